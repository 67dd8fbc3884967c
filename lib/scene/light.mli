(** Lights. *)

open Raylab_geometry

type source =
  | Directional of Direction.t  (** travels along this direction everywhere *)
  | Spherical of Vec3.t  (** shines from this point to all sides *)

type t = private {
  source : source;
  intensity : float;
  color : Color.t;
  power : Color.t;  (** [intensity * color], at most [max_float] *)
  origin : Origin.t;
}
(** The type for lights. *)

(** {1 Building}

    Raises [Invalid_argument] if [intensity] or a channel of [color] is
    negative or not finite, or a coordinate is not finite, or [direction] is
    the zero vector. *)

val directional : intensity:float -> color:Color.t -> direction:Vec3.t -> t
(** [directional ~intensity ~color ~direction] is light that travels along
    [direction], a vector of any length, as from a sun. *)

val spherical : intensity:float -> color:Color.t -> position:Vec3.t -> t
(** [spherical ~intensity ~color ~position] is light that shines from
    [position] to all sides and falls off with the square of the distance, as
    from a bulb.

    In a picture it gives nothing where that square is no double: beyond about
    1e154, where only an intensity of more than 1e304 could be seen, and within
    about 1e-162, as if the light were at the point itself. *)

val transformed : Change.t -> t -> t
(** [transformed change light] is [light] as [change] puts it; its intensity
    stays. A direction goes where the way from one point to another would:
    light that goes through two points goes through both afterwards.

    Raises [Invalid_argument] if its position is no longer finite, or its
    direction none. *)

(** {1 What reaches a point} *)

val received : t -> point:Vec3.t -> normal:Direction.t -> Color.t
(** [received light ~point ~normal] is what a surface through [point] receives
    on the side of [normal] if nothing is in the way:
    [max 0 cosine * falloff * intensity * color], at most [max_float]. [cosine]
    is that of the angle between [normal] and the way to the light, [falloff] 1
    over the squared distance of a point light, and 1 of a directional one. *)

type incidence = {
  mutable cosine : float;
      (** of the angle between the normal and the way to the light; not
          positive where the surface faces away *)
  mutable falloff : float;
      (** 1 over the squared distance for a point light, 1 for a directional
          one *)
}
(** The type for registers of how light meets a surface. *)

val create_incidence : unit -> incidence
(** [create_incidence ()] is a new register. *)

val meet : t -> Spot.t -> incidence -> bool
(** [meet light spot incidence] puts into [incidence] how [light] meets the
    surface at [spot], and is whether the surface faces it: whether the cosine
    is positive. Both numbers are 0 where the square of the distance to the
    light is no double. *)

val add : t -> incidence -> Raw_color.t -> unit
(** [add light incidence sum] adds what [light] gives there to [sum], of a
    surface that faces it. *)

(** {1 Shadows} *)

val shadow_ray :
  t -> point:Vec3.t -> normal:Direction.t -> offset:float -> Ray.t option
(** [shadow_ray light ~point ~normal ~offset] is the ray that asks whether
    [point] sees [light]. It starts [offset] from [point] along [normal]; for a
    spherical light it ends [offset] before the light, so that a light that
    lies on a surface is not in that surface's shadow. [None] if the light is
    where the ray would start, or so far away that the square of the distance
    is no double. *)

val aim : t -> Spot.t -> Raw_ray.t -> bool
(** [aim light spot ray] makes [ray], which is at the
    {!Raylab_geometry.Spot.start} of [spot], the shadow ray to [light] and is
    true; false if there is none. *)

val fan : t -> Fan.source option
(** [fan light] is what all shadow rays to [light] have in common, if that is
    something. *)

(** {1 Forms} *)

val name : t -> string
(** [name light] is the scene language's word: ["directional"] or
    ["spherical"]. *)

val with_origin : Origin.t -> t -> t
(** [with_origin origin light] is [light] with this origin, which at first is
    unknown. *)

val map_color : (Color.t -> Color.t) -> t -> t
(** [map_color f light] is [light] in the colour [f color].

    Raises [Invalid_argument] if [f] makes a colour that no light may have. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] have the same numbers. Origins do not
    count. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints
    [directional light, intensity 1, rgb 1 1 1, direction (0, -1, 0)] or
    [spherical light, intensity 1, rgb 1 1 1, position (0, 5, 0)]. *)
