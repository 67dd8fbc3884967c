(** Points and vectors of three-dimensional space.

    The frame is left-handed: x to the right, y up, z away from the viewer.
    Nothing here checks for NaN or infinity; both pass through as IEEE 754 has
    them. *)

type t = { x : float; y : float; z : float }

val make : float -> float -> float -> t
(** [make x y z] is the vector with these components. *)

val zero : t
(** [zero] is the vector (0, 0, 0). *)

val add : t -> t -> t
(** [add u v] is [u + v]. *)

val sub : t -> t -> t
(** [sub u v] is [u - v]: the way from [v] to [u]. *)

val scale : float -> t -> t
(** [scale k v] is [v] with each component multiplied by [k]. *)

val neg : t -> t
(** [neg v] is [-v]. *)

val dot : t -> t -> float
(** [dot u v] is the scalar product of [u] and [v]. *)

val cross : t -> t -> t
(** [cross u v] is the vector product of [u] and [v]: perpendicular to both, as
    long as the parallelogram between them is large. In this left-handed frame
    x, y and [cross x y], which is z, are the thumb, forefinger and middle
    finger of a left hand. *)

val length_squared : t -> float
(** [length_squared v] is [dot v v]. It overflows to infinity from components
    of about 1e154 on, and underflows to 0 below about 1e-162. *)

val length : t -> float
(** [length v] is the Euclidean length of [v], with the limits of
    {!length_squared}. *)

val magnitude : t -> float
(** [magnitude v] is the sum of the absolute components: a bound on the length
    that needs no square root and overflows only where the components do. *)

val is_finite : t -> bool
(** [is_finite v] is whether every component of [v] is finite. *)

val equal : t -> t -> bool
(** [equal u v] is whether the components are equal as numbers: 0 equals -0,
    NaN equals nothing. *)

(** Operators, for [Vec3.Infix.(a + (2. * b))]. *)
module Infix : sig
  val ( + ) : t -> t -> t
  (** [u + v] is {!add}[ u v]. *)

  val ( - ) : t -> t -> t
  (** [u - v] is {!sub}[ u v]. *)

  val ( * ) : float -> t -> t
  (** [k * v] is {!scale}[ k v]. *)

  val ( ~- ) : t -> t
  (** [-v] is {!neg}[ v]. *)
end

val pp : Format.formatter -> t -> unit
(** [pp] prints [(1, 2.5, -3)]; see {!Number.pp}. *)
