(** The rays of an explanation as lines, for pictures of it. *)

open Raylab_geometry
open Raylab_scene
open Raylab_tracer

(** The type for what a ray is sent for. *)
type kind =
  | Primary  (** from the eye *)
  | Mirrored
  | Unfollowed  (** to be followed, but the chain had ended *)
  | Lit of int  (** a shadow ray that reaches this light *)
  | Blocked of int  (** a shadow ray that does not *)

type line = {
  kind : kind;
  ray : Ray.t;
  length : float;  (** [infinity] if it goes on without end *)
  meets : (int * Object.t) option;  (** the object where it ends *)
}
(** The type for rays up to where they end. *)

val lines : Explain.t -> line list
(** [lines e] is the rays of [e], in the order in which they were cast. *)

val hits : Explain.t -> (Explain.surface_hit * Color.t) list
(** [hits e] is the hits of the chain, first to last, with their colours. *)

val objects : Explain.t -> int list
(** [objects e] is the numbers of the objects that were hit or in the way of a
    light, each once, in ascending order. *)
