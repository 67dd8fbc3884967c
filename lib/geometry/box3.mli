(** Boxes with sides along the axes. *)

type t = private { low : Vec3.t; high : Vec3.t }
(** The type for boxes, by the corners with the least and with the greatest
    coordinates. They may be equal, in one coordinate or in all. *)

val make : low:Vec3.t -> high:Vec3.t -> t
(** [make ~low ~high] is the box between these corners.

    Raises [Invalid_argument] if a coordinate of [low] is greater than that of
    [high], or NaN. *)

val around : Vec3.t list -> t
(** [around points] is the box around [points], wider by 2^-44 of their
    coordinates: more than the rounding errors of what is hit between them.

    Raises [Invalid_argument] if there are none, or a coordinate is NaN. *)

val centre : t -> Vec3.t
(** [centre box] is the point in its middle. *)

val reach : t -> float
(** [reach box] is half the length of its longest side. *)

val union : t -> t -> t
(** [union a b] is the smallest box that holds [a] and [b]. *)

val intersection : t -> t -> t option
(** [intersection a b] is what is in [a] and in [b]; [None] if that is nothing.
*)

val wider : float -> t -> t
(** [wider w box] is [box], by [w] farther out on each side. *)

val equal : t -> t -> bool
(** [equal a b] is whether the corners are equal. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [(-1, -1, 5) to (1, 1, 7)]. *)
