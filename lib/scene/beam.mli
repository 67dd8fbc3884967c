(** The cone of a spot light. *)

open Raylab_geometry

type t = private {
  position : Vec3.t;
  target : Vec3.t;  (** at which it shines *)
  inner : float;  (** the angle in degrees, from the axis, of its full light *)
  outer : float;  (** the angle beyond which it gives nothing *)
  axis : Direction.t;  (** from [position] to [target] *)
  full : float;  (** the cosine of [inner] *)
  none : float;  (** the cosine of [outer] *)
}
(** The type for cones. *)

(** The type for why numbers make no cone. *)
type problem =
  | Not_finite
  | No_axis  (** position and target are one point, or too far apart *)
  | Inner_beyond_outer
  | Not_below_180  (** the outer angle *)

val make :
  position:Vec3.t ->
  target:Vec3.t ->
  inner:float ->
  outer:float ->
  (t, problem) result
(** [make ~position ~target ~inner ~outer] is the cone around the axis from
    [position] to [target]. An angle that is negative is [Not_finite]. *)

val make_exn :
  position:Vec3.t -> target:Vec3.t -> inner:float -> outer:float -> t
(** [make_exn ~position ~target ~inner ~outer] is that of {!make}.

    Raises [Invalid_argument] where there is none. *)

val aside : t -> float -> float -> float -> float
(** [aside beam x y z] is the cosine of the angle between the axis and the way
    back from the point from which the light is seen along (x, y, z), of any
    length that can be squared. *)

val part : t -> float -> float
(** [part beam c] is which part of its light it sends along a way at an angle
    of cosine [c] to its axis: 1 inside of the inner angle, 0 outside of the
    outer one, and between them [3 t^2 - 2 t^3], where [t] goes from 0 to 1 as
    [c] does from the outer to the inner one's. *)

val angle : t -> Vec3.t -> float
(** [angle beam point] is the angle in degrees between the axis and the way to
    [point]. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] have the same numbers. *)
