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

(** The type for terms of a colour: what it is, and how it came about. *)
type source =
  | Background
  | Emitted  (** what the surface gives off *)
  | Diffused of { light : Color.t }
      (** albedo times [light], the sum of all contributions *)
  | Mirror
      (** mirror times the colour of the mirrored ray; there is no such ray if
          the mirror is 0 *)

type term = { source : source; color : Color.t }
(** A term of a colour. *)

(** The type for events. The sums hold exactly, added from the left; a sum or
    product too large for a double is the largest double. *)
type t =
  | Opened of { role : role; ray : Ray.t; left : int }
      (** A ray is cast, with [left] rays left in its chain, itself included.
      *)
  | Met of Hit.t  (** The first hit of the ray. *)
  | Faces_away of { light : int; cosine : float }
      (** The surface is turned away from the light: [cosine], of the angle
          between the normal and the way to the light, is not positive. It is
          0, too, where a point light gives nothing since the square of its
          distance is no double. *)
  | Shadow_ray of { light : int; ray : Ray.t }
      (** A ray is sent to find out whether anything blocks the light. *)
  | Blocked of {
      light : int;
      by : int;
      primitive : int option;  (** which of it, from 1, if it is a solid *)
      t : float;
      point : Vec3.t;
    }
      (** Object [by] is in the way: it is what the shadow ray hits first, at
          distance [t], at [point]. *)
  | Lit of {
      light : int;
      cosine : float;
      falloff : float;
          (** 1 over the squared distance for a point light, else 1 *)
      contribution : Color.t;
          (** [cosine * falloff * intensity * colour] of the light *)
      past : int option;
          (** the first object that would be in the way, but is shadowless *)
    }  (** Nothing is in the way. *)
  | Closed of { left : int; terms : term list; color : Color.t }
      (** The ray that was opened last, and not closed, has [color], the sum of
          [terms]; [left] is what it was opened with. If it met nothing, or was
          not followed because none was left, that is the background. *)
  | Done of Color.t  (** The colour of the first ray. *)

val source_name : source -> string
(** [source_name source] is a word for it, such as ["diffused"]. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints the event on one line, such as
    [nearest hit: object 3, t = 5 at (0, 0, 1), normal (0, 0, -1)]. *)
