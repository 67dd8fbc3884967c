(** The leaves of a bounding volume hierarchy: spheres, and the balls around
    other shapes, as arrays of numbers that the building of the tree brings
    into the order of its leaves. *)

type t = private {
  spheres : float array;  (** x, y, z and radius of each sphere or ball *)
  numbers : int array;  (** the number of its shape, in the same order *)
  shapes : Shape.t array;  (** the shapes by number; none if all are spheres *)
}

val of_shapes : quick:bool -> Shape.t array -> t
(** [of_shapes ~quick shapes] is those among [shapes] that have a
    {!Shape.ball}, each with the number that is its place there. Spheres count
    as other shapes if [quick] is false. *)

val count : t -> int
(** [count leaves] is the number of balls. *)

val centre : t -> int -> int -> float
(** [centre leaves place axis] is a coordinate of the centre of the ball at
    [place]: x for [axis] 0, y for 1 and z for 2. *)

val radius : t -> int -> float
(** [radius leaves place] is the radius of the ball at [place]. *)

val swap : t -> int -> int -> unit
(** [swap leaves a b] exchanges the balls at [a] and [b]. *)

val mark_others : quick:bool -> t -> unit
(** [mark_others ~quick leaves] makes the radius of each ball infinite that is
    not the shape itself, once the tree is built: so a ray that comes to it
    hits the ball, and then {!other_distance} tells. *)

val other_distance : t -> int -> Raw_ray.t -> float
(** [other_distance leaves place ray] is {!Shape.nearest_raw} of the shape at
    [place]. *)
