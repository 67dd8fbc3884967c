(** Explanations of all pixels of a scene. *)

open Raylab_tracer

val pixels : Trace.t -> (int * int) list
(** [pixels scene] is the places of its pixels. *)

val explanations : Trace.t -> ((int * int) * Explain.t) list
(** [explanations scene] explains all of them. *)

val holds :
  ?count:int ->
  ?max_side:int ->
  string ->
  (Trace.t -> bool) ->
  unit Alcotest.test_case list
(** [holds what property] is the tests that [property] is true of random
    scenes, with everyday numbers and with numbers of any size. *)
