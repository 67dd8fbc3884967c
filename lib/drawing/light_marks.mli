(** The lights in a picture of a path. *)

open Raylab_scene

val draw : Panel.t -> shown:int list -> Light.t list -> Sketch.t
(** [draw panel ~shown lights] is a mark for each spherical light, at the edge
    of the panel if the light is farther away, one with its cone for each spot,
    the parallelogram of each area light, and an arrow at the edge for each
    directional one, that points as it shines, except for those whose numbers
    are in [shown]. At most 20 lights are drawn. *)
