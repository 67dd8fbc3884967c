(** Pictures of the path of a ray: from above and from the side. *)

open Raylab_scene
open Raylab_tracer

val make : ?sample:int -> Scene.t -> Explain.pixel -> Sheet.t
(** [make scene pixel] is a sheet that shows how [pixel], an explanation of one
    of [scene], came about: the rays of the first sample of each
    {!Raylab_explanation.Group}, or of that [sample], counted from 1. Under
    {!Raylab_explanation.Summary.of_pixel} two panels side by side, at the same
    scale, from above (x and z) and from the side (z and y); see {!Extent},
    {!Scenery} and {!Rays}. No label overlaps another; one for which there is
    no room near its place is left out. *)

val to_svg : ?sample:int -> Scene.t -> Explain.pixel -> string
(** [to_svg ~sample scene pixel] is {!make} as an SVG file. *)
