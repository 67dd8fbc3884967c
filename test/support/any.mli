(** Explanations of all pixels of a scene. *)

open Raylab_tracer

val pixels : Prepared.t -> (int * int) list
(** [pixels scene] is the places of its pixels. *)

val explained : Prepared.t -> Explain.pixel list
(** [explained scene] explains all of them. *)

val explanations : Prepared.t -> ((int * int) * Explain.t) list
(** [explanations scene] is the place of each, and the ray through its centre.
*)

val holds :
  ?count:int ->
  ?max_side:int ->
  string ->
  (Prepared.t -> bool) ->
  unit Alcotest.test_case list
(** [holds what property] is the tests that [property] is true of random
    scenes, with everyday numbers and with numbers of any size. *)
