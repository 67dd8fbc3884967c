(** What patterns are at fixed points, before anything is rendered. *)

open Raylab_source
open Raylab_scene

val errors : Sources.t -> Scene.t -> Scene_error.t list
(** [errors sources scene] is what goes wrong where each pattern of [scene] is
    evaluated at a thousand points of the object that has it, and the
    background in a thousand directions. Objects one after another with the
    same surface share the thousand, and where there are more than 200 surfaces
    with patterns each has fewer points. *)
