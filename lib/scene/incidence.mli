(** How light meets a surface: what a light gives at a point, and the shadow
    rays that ask whether it gets there.

    A light shines from one point or several ({!Light.points}), numbered from
    0; what it gives is the mean of what its points give. For all kinds of
    lights and each of their points that goes one way: {!meet}, then {!aim},
    and if nothing is in the way {!add}. *)

open Raylab_geometry

type t = {
  mutable x : float;
  mutable y : float;
  mutable z : float;
      (** the point from which the light shines; as it was if the light is
          directional *)
  mutable cosine : float;
      (** of the angle between the normal and the way to the light; not
          positive where the surface faces away *)
  mutable falloff : float;
      (** 1 over the squared distance to the light; 1 if it is directional or
          unfading *)
  mutable cone : float;
      (** which part of its light a spot sends this way, see {!Beam.part}; 1 of
          all other lights *)
}
(** The type for registers of how light meets a surface. *)

val create : unit -> t
(** [create ()] is a new register. *)

val meet : Light.t -> int -> Raw_ray.t -> Spot.t -> t -> bool
(** [meet light k ray spot incidence] puts into [incidence] how the light of
    point [k] of [light] meets the surface at [spot], and is whether the
    surface faces it: whether the cosine is positive. Where the square of the
    distance to the light is no double all numbers are 0. The seed of [ray]
    decides where the points of an area light are. *)

val add : Light.t -> t -> Raw_color.t -> unit
(** [add light incidence sum] adds what a point of [light] gives there to
    [sum], of a surface that faces it:
    [cosine * falloff * cone * intensity * color], at most [max_float]. *)

val aim : Light.t -> t -> Spot.t -> Raw_ray.t -> bool
(** [aim light incidence spot ray] makes [ray], which is at the
    {!Raylab_geometry.Spot.start} of [spot], the shadow ray to the point of
    [light] that [incidence] has {!meet}, and is true; false if there is none.
    Of a light with a position the ray ends the offset of [spot] before it, so
    that a light that lies on a surface is not in that surface's shadow. There
    is no ray if the light is where it would start, or so far away that the
    square of the distance is no double. *)

(** {1 As pure functions} *)

val received :
  ?seed:float -> Light.t -> point:Vec3.t -> normal:Direction.t -> Color.t
(** [received light ~point ~normal] is what a surface through [point] receives
    on the side of [normal] if nothing is in the way: the mean of what the
    points of [light] give, their sum divided by their number. [seed], by
    default 0, is that of the ray which sees the surface. *)

val shadow_ray :
  ?seed:float ->
  ?k:int ->
  Light.t ->
  point:Vec3.t ->
  normal:Direction.t ->
  offset:float ->
  Ray.t option
(** [shadow_ray light ~point ~normal ~offset] is the ray that asks whether
    [point] sees point [k] of [light], by default 0: that of {!aim}, with an
    offset of [offset]. *)
