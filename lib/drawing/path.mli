(** The rays of an explanation as lines in space: what drawings of it draw. *)

open Raylab_geometry
open Raylab_scene
open Raylab_tracer

(** The type for kinds of rays. *)
type kind =
  | Primary  (** from the eye *)
  | Mirrored
  | Refracted
  | Unfollowed
      (** to be followed, but the chain had ended, or it was too faint *)
  | Lit  (** a shadow ray that reaches its light *)
  | Blocked  (** a shadow ray that does not *)

type ray = {
  kind : kind;
  number : int;
      (** in the order of the rays that are no shadow rays, from 1; that of a
          shadow ray is that of the ray from whose hit it starts *)
  ray : Ray.t;
  length : float;  (** [infinity] if it goes on without end *)
  meets : int option;  (** the number of the object where it ends *)
  light : int option;  (** the number of the light to which it goes *)
  tint : Color.t;
      (** what is left of the light that comes along a shadow ray; white of
          other rays *)
  words : string;  (** where it goes, such as [to sphere 3, t = 4.5] *)
}
(** The type for rays up to where they end. *)

type hit = {
  number : int;  (** of the object *)
  point : Vec3.t;
  color : Color.t;  (** that of the ray that hit it, as a picture shows it *)
}
(** The type for hits of the chain. *)

type t = { rays : ray list; hits : hit list }
(** The type for paths: all rays in the order in which they were cast, and all
    hits. *)

val of_rays : Film.t -> Explain.t list -> t
(** [of_rays film rays] is the path of all [rays], one after another, as [film]
    shows them. *)

val end_of : ray -> Vec3.t option
(** [end_of ray] is where [ray] ends, if it does. *)

val objects : t -> int list
(** [objects path] is the numbers of the objects that were hit or in the way of
    a light, each once, in ascending order. *)
