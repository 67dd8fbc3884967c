(** Explanations: why a ray has its colour.

    An explanation is the tree of what the evaluator did when it computed the
    colour, made of its own {!Event}s: rendering and explaining are one
    computation, so the colour of the root is the colour of the pixel, bit for
    bit. *)

open Raylab_geometry
open Raylab_scene

(** What a light gives to a hit. *)
type verdict =
  | Faces_away of { cosine : float }
      (** The surface is turned away; [cosine] is not positive. It is 0, too,
          where the square of the distance to the light is no double. *)
  | Blocked of {
      shadow_ray : Ray.t;
      by : int;  (** the number of the blocking object, from 1 *)
      blocker : Object.t;
      t : float;  (** along the shadow ray *)
      point : Vec3.t;
    }
  | Lit of {
      shadow_ray : Ray.t option;
          (** none if the light is where that ray would start *)
      cosine : float;
      falloff : float;
      contribution : Color.t;
    }

type light = { number : int; light : Light.t; verdict : verdict }
(** A light of the scene, with its number from 1, and its verdict. *)

type t = {
  ray : Ray.t;
  left : int;  (** rays left in the chain, this one included *)
  outcome : outcome;
  color : Color.t;
}
(** The type for explanations of a ray. *)

and outcome =
  | Chain_ended  (** no ray was left; [color] is the background *)
  | Missed  (** the ray hit nothing; [color] is the background *)
  | Hit of surface_hit

and surface_hit = {
  hit : Hit.t;
  object_ : Object.t;
  surface : Surface.t;  (** what [object_]'s surface is at the hit *)
  meaning : Surface.meaning;  (** what [surface] denotes *)
  lights : light list;
      (** in the order of the scene; none if the surface has no albedo, which
          makes light irrelevant *)
  light : Color.t;  (** the sum of the contributions, from the left *)
  emitted : Color.t;
  diffused : Color.t;  (** albedo times [light] *)
  mirrored : Color.t;  (** mirror times the colour of [reflection] *)
  reflection : t option;  (** the mirrored ray; none if [mirror] is 0 *)
}
(** A hit. [emitted + diffused + mirrored], added from the left, is the colour.
*)

val ray : Trace.t -> Ray.t -> t
(** [ray scene r] explains [Trace.ray scene r]. *)

val pixel : Trace.t -> x:int -> y:int -> t
(** [pixel scene ~x ~y] explains [Trace.pixel scene ~x ~y], y from the top. *)

val steps : Trace.t -> Ray.t -> Event.t Seq.t
(** [steps scene r] is the events of [Trace.ray scene r], a persistent
    sequence: an older part of it can be read again at any time. The evaluation
    runs when the first event is asked for. The last event is [Done] with the
    colour. *)
