(** Pictures of the path of a ray, as SVG: from above and from the side. *)

open Raylab_scene
open Raylab_tracer

val to_svg : ?pixel:int * int -> Scene.t -> Explain.t -> string
(** [to_svg ~pixel scene e] is an SVG file that shows how [e], an explanation
    of a ray of [scene], came about: under {!Summary.to_string} two views side
    by side, at the same scale, from above (x and z) and from the side (z and
    y); see {!Frame}, {!Scenery} and {!Route}. No label overlaps another; one
    for which there is no room near its place is left out. *)
