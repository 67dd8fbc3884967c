(** The spheres of a bounding volume hierarchy, as arrays of numbers that the
    building of the tree brings into the order of its leaves. *)

type t = private {
  spheres : float array;  (** x, y, z and radius of each sphere *)
  numbers : int array;  (** the number of each sphere, in the same order *)
}

val of_shapes : Shape.t array -> t
(** [of_shapes shapes] is the spheres among [shapes], each with the number that
    is its place there. *)

val count : t -> int
(** [count leaves] is the number of spheres. *)

val centre : t -> int -> int -> float
(** [centre leaves place axis] is a coordinate of the centre of the sphere at
    [place]: x for [axis] 0, y for 1 and z for 2. *)

val radius : t -> int -> float
(** [radius leaves place] is the radius of the sphere at [place]. *)

val swap : t -> int -> int -> unit
(** [swap leaves a b] exchanges the spheres at [a] and [b]. *)
