(** Questions to shapes, whose answers are values. *)

open Raylab_geometry

val distance : Shape.t -> Ray.t -> float
(** [distance shape ray] is that of {!Shape.nearest}, or [infinity] if there is
    none. *)

val crossings : Shape.t -> Ray.t -> (float * int * bool) list
(** [crossings shape ray] is {!Shape.crossings}: distances, parts, and whether
    the ray enters. *)

val spot : ?part:int -> Shape.t -> reach:float -> Ray.t -> Spot.t
(** [spot shape ~reach ray] is what {!Shape.settle} knows of the place where
    [ray], cut off at [reach], meets [part], by default 0, of [shape]. *)
