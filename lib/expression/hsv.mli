(** Colours by hue, saturation and value (A. R. Smith,
    {e Color gamut transform pairs}, 1978). *)

open Raylab_geometry

val color : h:float -> s:float -> v:float -> Vec3.t
(** [color ~h ~s ~v] is red, green and blue of the hue at [h] degrees on the
    circle: red at 0, yellow at 60, green at 120, then cyan, blue, magenta. The
    saturation [s] is from 0, grey, to 1; [v] is the largest channel. *)
