(** Pictures of the path of a ray: from above and from the side. *)

open Raylab_scene
open Raylab_tracer

val make : ?pixel:int * int -> Scene.t -> Explain.t -> Sheet.t
(** [make ~pixel scene e] is a sheet that shows how [e], an explanation of a
    ray of [scene], came about: under {!Raylab_explanation.Summary.to_string}
    two panels side by side, at the same scale, from above (x and z) and from
    the side (z and y); see {!Extent}, {!Scenery} and {!Rays}. No label
    overlaps another; one for which there is no room near its place is left
    out. *)

val to_svg : ?pixel:int * int -> Scene.t -> Explain.t -> string
(** [to_svg ~pixel scene e] is {!make} as an SVG file. *)
