(** Bounces: the rays that a hit sends on, one after another.

    A stack of numbers, so that however many rays a hit sends on, nothing is
    allocated but where the stack has to grow. Each hit that may send on
    several puts its bounces on it, follows them, and takes them away: first
    the mirrored ray, and then one for each refraction of the surface, all of
    them, those of no weight included. *)

open Raylab_geometry
open Raylab_scene

type t
(** The type for stacks. *)

val create : unit -> t
(** [create ()] is an empty stack. *)

val count : t -> int
(** [count t] is how many bounces are on [t]. *)

val drop_to : t -> int -> unit
(** [drop_to t count] takes all but the first [count] away. *)

val add : t -> Raw_lobes.t -> Spot.t -> Raw_ray.t -> unit
(** [add t lobes spot ray] adds what a surface of these lobes sends on where
    [ray] meets it at [spot]. Where a refraction is totally reflected its part
    is added to the mirror's. If several have weight, each gets of the share of
    [ray] its largest channel, divided by the sum of all these where that is
    more than 1; the only one keeps all. *)

val least_share : float
(** [least_share] is 1/1024: what has less is not followed. *)

(** {1 One of them}

    By its place in the stack, from 0. *)

val has_weight : t -> int -> bool
(** [has_weight t k] is whether the weight of bounce [k] is not black: if it
    is, there is no such ray. *)

val load : t -> int -> Raw_ray.t -> unit
(** [load t k ray] makes [ray] the ray of bounce [k], with its share. *)

val weigh : t -> int -> Raw_color.t -> unit
(** [weigh t k color] puts the weight of bounce [k] times [color] in place of
    its weight. *)

val red : t -> int -> float
(** [red t k] is the red of bounce [k]'s weight, or of what is in its place. *)

val green : t -> int -> float
(** [green t k] is its green. *)

val blue : t -> int -> float
(** [blue t k] is its blue. *)

val color : t -> int -> Color.t
(** [color t k] is these as a colour. *)

val share : t -> int -> float
(** [share t k] is Fresnel's share of the refraction of bounce [k]. *)

val cosine : t -> int -> float
(** [cosine t k] is the cosine of its angle, 0 if it is totally reflected. *)
