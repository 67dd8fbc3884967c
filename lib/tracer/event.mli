(** Events: what the tracer does on the way from a ray to its colour, in the
    order in which it does it.

    The evaluator that renders pictures tells them to whoever listens, so they
    are the rendering itself, with its very numbers. Objects and lights are
    numbered by their place in the scene, from 1. *)

open Raylab_geometry
open Raylab_scene

(** The type for events. The sums hold exactly, added from the left; a sum or
    product too large for a double is the largest double. *)
type t =
  | Cast of { ray : Ray.t; left : int }
      (** A ray is cast, with [left] rays left in its chain, itself included.
      *)
  | Chain_ended of Color.t
      (** No ray is left: the ray is not followed, the background stands in. *)
  | Missed of Color.t  (** The ray hits nothing and shows the background. *)
  | Nearest_hit of Hit.t  (** The first hit of the ray. *)
  | Faces_away of { light : int; cosine : float }
      (** The surface is turned away from the light: [cosine], of the angle
          between the normal and the way to the light, is not positive. It is
          0, too, where a spherical light gives nothing since the square of its
          distance is no double. *)
  | Shadow_ray of { light : int; ray : Ray.t }
      (** A ray is sent to find out whether anything blocks the light. *)
  | Blocked of { light : int; by : int; t : float; point : Vec3.t }
      (** Object [by] is in the way: it is what the shadow ray hits first, at
          distance [t], at [point]. *)
  | Lit of {
      light : int;
      cosine : float;
      falloff : float;
          (** 1 over the squared distance for a spherical light, else 1 *)
      contribution : Color.t;
          (** [cosine * falloff * intensity * colour] of the light *)
    }  (** Nothing is in the way. *)
  | Bounce of { ray : Ray.t; left : int }
      (** The mirrored ray is cast, with [left] rays left in the chain. The
          events up to its colour follow. *)
  | Mixed of {
      emitted : Color.t;  (** the surface's emission *)
      light : Color.t;  (** the sum of all contributions *)
      diffused : Color.t;  (** albedo times [light] *)
      mirrored : Color.t;  (** mirror times the colour of the mirrored ray *)
      color : Color.t;  (** [emitted + diffused + mirrored] *)
    }  (** The colour of a hit is put together. *)
  | Done of Color.t  (** The colour of the first ray. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints the event on one line, such as
    [nearest hit: object 3, t = 5 at (0, 0, 1), normal (0, 0, -1)]. *)
