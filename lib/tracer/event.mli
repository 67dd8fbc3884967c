(** Events: what the tracer does on the way from a ray to its colour, in the
    order in which it does it.

    The evaluator that renders pictures tells them to whoever listens, so they
    are the rendering itself, with its very numbers. They are brackets: each
    ray is opened, and closed with its colour, and what happens between is
    about it, other rays included, which are opened and closed there. Objects
    and lights are numbered by their place in the scene, from 1. *)

open Raylab_geometry
open Raylab_scene

(** The type for what a ray is cast for. *)
type role =
  | Primary  (** asked for from outside: for a pixel, or by hand *)
  | Mirrored  (** to see what the surface mirrors *)
  | Refracted  (** to see what is behind the surface *)

(** The type for terms of a colour: what it is, and how it came about. *)
type source =
  | Background
  | Emitted  (** what the surface gives off *)
  | Diffused of { ambient : Color.t; light : Color.t }
      (** albedo times [light], the sum of [ambient] and all contributions *)
  | Shine of { sharpness : float; shine : Color.t }
      (** the colour of the highlight of this sharpness times [shine], the sum
          of what the lights give to it *)
  | Mirror of { weight : Color.t }
      (** [weight] times the colour of the mirrored ray: the mirror, Fresnel's
          share of glass, and all that is totally reflected *)
  | Refraction of {
      index : float;
      weight : Color.t;
      share : float;
          (** Fresnel's, at this angle: of the glass in it that is mirrored *)
      cosine : float;
          (** of the angle between the refracted ray and the normal; 0 if there
              is none, since it is totally reflected *)
    }  (** [weight] times the colour of the ray that goes through *)

type term = { source : source; color : Color.t }
(** A term of a colour. *)

type obstacle = {
  by : int;  (** the number of the object *)
  primitive : int option;  (** which of it, from 1, if it is a solid *)
  t : float;  (** how far along the shadow ray *)
  point : Vec3.t;
}
(** The type for what a shadow ray meets. *)

type crossing = {
  met : obstacle;
  part : Color.t;  (** what it lets through of the light *)
}
(** The type for surfaces that light goes through. *)

type cone = { angle : float; part : float }
(** Of a point in the cone of a spot: the angle in degrees from its axis, and
    which part of its light goes there, 1 inside of the inner angle. *)

(** The type for events. What has a [cell] is about the point of that cell of
    an area light, from 1, as if that were a light of its own. The sums hold
    exactly, added from the left; a sum or product too large for a double is
    the largest double. *)
type t =
  | Opened of { role : role; ray : Ray.t; left : int }
      (** A ray is cast, with [left] rays left in its chain, itself included.
      *)
  | Met of Hit.t  (** The first hit of the ray. *)
  | Faces_away of { light : int; cell : int option; cosine : float }
      (** The surface is turned away from the light: [cosine], of the angle
          between the normal and the way to the light, is not positive. It is
          0, too, where a point light gives nothing since the square of its
          distance is no double. *)
  | Outside of { light : int; angle : float }
      (** The surface is outside of the cone of a spot: at this angle in
          degrees from its axis. *)
  | Shadow_ray of { light : int; cell : int option; ray : Ray.t }
      (** A ray is sent to find out whether anything blocks the light. *)
  | Blocked of {
      light : int;
      cell : int option;
      by : int;
      primitive : int option;  (** which of it, from 1, if it is a solid *)
      t : float;
      point : Vec3.t;
    }
      (** Object [by] is in the way: it is what the shadow ray hits first, at
          distance [t], at [point]. *)
  | Lit of {
      light : int;
      cell : int option;
      cosine : float;
      falloff : float;
          (** 1 over the squared distance; 1 for a light that is directional or
              unfading *)
      cone : cone option;  (** if it is a spot *)
      contribution : Color.t;
          (** [cosine * falloff * part * intensity * colour] of the light,
              times each part that it goes [through] *)
      shines : Color.t list;
          (** the same for each highlight of the surface, with its power
              instead of the cosine; see {!Raylab_scene.Shine} *)
      past : int option;
          (** the first object that would be in the way, but is shadowless *)
      through : crossing list;
          (** the surfaces that refract in the way, the nearest first *)
    }  (** Nothing is in the way that ends it. *)
  | Mean of {
      light : int;
      points : int;
      contribution : Color.t;
      shines : Color.t list;
    }
      (** What an area light gives: the sum of what its points give, divided by
          their number. *)
  | Closed of { left : int; terms : term list; color : Color.t }
      (** The ray that was opened last, and not closed, has [color], the sum of
          [terms]; [left] is what it was opened with. If it met nothing, or was
          not followed because none was left, that is the background. *)
  | Done of Color.t  (** The colour of the first ray. *)

val sends : source -> role option
(** [sends source] is what ray its term needs: a mirrored or a refracted one,
    unless its weight is black. *)

val source_name : source -> string
(** [source_name source] is a word for it, such as ["diffused"]. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints the event on one line, such as
    [nearest hit: object 3, t = 5 at (0, 0, 1), normal (0, 0, -1)]. *)
