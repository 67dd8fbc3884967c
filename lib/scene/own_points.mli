(** Fixed points of shapes, at which patterns are tried. *)

open Raylab_geometry

val of_shape : int -> Shape.t -> Vec3.t Seq.t
(** [of_shape count shape] is up to [count] points of [shape] in its own
    coordinates, spread over all of it or, if it has no end, over what is near
    and far of its point: the same ones each time. There are fewer, even none,
    where a shape is so thin that its box is mostly empty. *)

val directions : int -> Vec3.t Seq.t
(** [directions count] is [count] fixed directions to all sides. *)
