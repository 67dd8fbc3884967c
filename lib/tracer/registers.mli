(** The registers that one domain works with while it evaluates rays.

    They are records of mutable doubles, because in OCaml a double that crosses
    a function call or lies in an ordinary record costs an allocation, and a
    picture has millions of them. Nobody but {!Evaluator} and its parts sees
    them. *)

open Raylab_geometry
open Raylab_scene

type hit = {
  mutable x : float;
  mutable y : float;
  mutable z : float;
  mutable nx : float;
  mutable ny : float;
  mutable nz : float;
  mutable offset : float;
}
(** A hit: its point, the unit normal on the side of the ray, and how far off
    rays start that leave it. *)

type color = { mutable r : float; mutable g : float; mutable b : float }
(** A colour on the way. *)

type t = {
  scene : Flat_scene.t;
  observe : (Event.t -> unit) option;  (** who is told of every event *)
  query : Query.t;
  tally : Tally.t;
  ray : Raw_ray.t;  (** the ray of the chain *)
  shadow_ray : Raw_ray.t;
  hit : hit;
  light : color;  (** what reaches the hit *)
  color : color;  (** what the ray brings *)
  row : float array;  (** what a surface that varies denotes at the hit *)
}
(** The type for registers. *)

val create : ?observe:(Event.t -> unit) -> Flat_scene.t -> t
(** [create scene] is new registers for [scene]. *)

val load : t -> Ray.t -> unit
(** [load t ray] puts [ray] into its register. *)

val set : color -> float -> float -> float -> unit
(** [set color r g b] puts a colour into [color], each channel limited as
    {!Raylab_scene.Saturate.limit} does. *)

val color_of : color -> Color.t
(** [color_of color] is what [color] holds. *)
