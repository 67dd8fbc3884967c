(** Explanations: why a ray has its colour.

    An explanation is the tree of what the evaluator did when it computed the
    colour, made of its own {!Event}s: rendering and explaining are one
    computation, so the colour of the root is the colour of the pixel, bit for
    bit. Objects and lights come with their place, if they have one, so that
    who tells of them needs no scene. *)

open Raylab_geometry
open Raylab_scene

type primitive = {
  index : int;  (** among those of its solid, from 1 *)
  object_ : Object.t;
  place : Provenance.t option;
  is_taken_away : bool;  (** whether the solid is without it *)
}
(** A primitive of a solid. *)

type past = { number : int; object_ : Object.t; place : Provenance.t option }
(** An object that a ray passes. *)

type crossed = {
  by : int;  (** the number of the object *)
  object_ : Object.t;
  primitive : primitive option;
  place : Provenance.t option;  (** of the object *)
  t : float;  (** along the shadow ray *)
  point : Vec3.t;
  part : Color.t;  (** what it lets through of the light *)
}
(** A surface that light goes through. *)

(** What a light gives to a hit. *)
type verdict =
  | Faces_away of { cosine : float }
      (** The surface is turned away; [cosine] is not positive. It is 0, too,
          where the square of the distance to the light is no double. *)
  | Outside of { angle : float }
      (** It is outside of the cone of a spot, at this angle in degrees from
          its axis. *)
  | Blocked of {
      shadow_ray : Ray.t;
      by : int;  (** the number of the blocking object, from 1 *)
      blocker : Object.t;
      primitive : primitive option;
      place : Provenance.t option;  (** of the blocking object *)
      t : float;  (** along the shadow ray *)
      point : Vec3.t;
    }
  | Lit of {
      shadow_ray : Ray.t option;
          (** none if the light is where that ray would start *)
      cosine : float;
      falloff : float;
      cone : Event.cone option;  (** if the light is a spot *)
      contribution : Color.t;
      shines : Color.t list;
          (** what it gives to each highlight of the surface *)
      past : past option;
          (** the first object in the way that is shadowless *)
      through : crossed list;
          (** the surfaces that it goes through, the nearest to the hit first
          *)
    }
  | Mean of {
      points : verdict list;  (** of each point of an area light *)
      contribution : Color.t;
          (** the sum of their contributions, added from the left, divided by
              their number *)
      shines : Color.t list;  (** likewise *)
    }

type light = {
  number : int;  (** from 1 *)
  light : Light.t;
  place : Provenance.t option;
  verdict : verdict;
}
(** A light of the scene, and its verdict. *)

type t = {
  role : Event.role;
  ray : Ray.t;
  left : int;  (** rays left in the chain, this one included *)
  outcome : outcome;
  terms : term list;
  color : Color.t;  (** the sum of the terms, added from the left *)
}
(** The type for explanations of a ray. *)

and outcome =
  | Chain_ended  (** no ray was left; the one term is the background *)
  | Too_faint
      (** the ray's share is less than {!Bounces.least_share}, so that it was
          not followed; the one term is the background *)
  | Missed  (** the ray hit nothing; the one term is the background *)
  | Hit of surface_hit

and surface_hit = {
  hit : Hit.t;
  object_ : Object.t;
  primitive : primitive option;
  place : Provenance.t option;  (** of the object *)
  surface : Surface.t;  (** what [object_]'s surface is at the hit *)
  lobes : Lobes.t;  (** what [surface] denotes *)
  lights : light list;
      (** in the order of the scene; none if the surface has no albedo, which
          makes light irrelevant *)
}

and term = {
  source : Event.source;
  color : Color.t;
  ray : t option;  (** the ray of which [color] is a part, if there is one *)
}
(** A term of a colour. *)

val ray : Prepared.t -> Ray.t -> t
(** [ray scene r] explains [Tracer.color scene r]. *)

val steps : Prepared.t -> Ray.t -> Event.t Seq.t
(** [steps scene r] is the events of [Tracer.color scene r], a persistent
    sequence: an older part of it can be read again at any time. The evaluation
    runs when the first event is asked for. The last event is [Done] with the
    colour. *)

(** {1 Reading} *)

val tint : crossed list -> Color.t
(** [tint through] is the part of the light that is left behind all of
    [through]. *)

val next : t -> t list
(** [next e] is the rays of the terms of [e], in their order: none, or the
    mirrored one, or that and those that go through the surface. *)

val sum_of : (Event.source -> bool) -> t -> Color.t
(** [sum_of holds e] is the sum of the terms of [e] whose source [holds]. *)

val light : t -> Color.t
(** [light e] is the sum of the ambient light and what all lights give at the
    hit of [e]; black if it hits nothing. *)

val ambient : t -> Color.t
(** [ambient e] is the ambient light at the hit of [e]; black if it hits
    nothing. *)

(** {1 Pixels} *)

type sample = {
  color : Color.t;  (** of [ray], exposed: times the exposure, in \[0, 1\] *)
  ray : t;
}
(** The type for samples of a pixel. *)

type pixel = {
  x : int;
  y : int;  (** from the top *)
  film : Film.t;  (** of the scene *)
  samples : sample list;  (** at least one, and the first through the centre *)
  cause : Centres.neighbour option;
      (** the pixel beside it because of which it has several samples *)
  color : Color.t;
      (** the mean of the samples: their sum, added from the left, divided by
          their number *)
}
(** The type for explanations of a pixel. *)

val pixel : Prepared.t -> x:int -> y:int -> pixel
(** [pixel scene ~x ~y] explains [Tracer.pixel scene ~x ~y]. *)

val centre : pixel -> t
(** [centre pixel] is the ray of the first sample. *)
