(** Explanations from JSON, by the schema that [Json] documents.

    What does not follow it raises {!Decode_scene.Wrong}. *)

open Raylab_tracer

val ray : Yojson.Safe.t -> Explain.t
(** [ray json] is the explanation of which [json] is the RAY. *)

type pixel = {
  x : int;
  y : int;
  rgb : int * int * int;
  summary : string;
  explanation : Explain.t;
}

val document : Yojson.Safe.t -> pixel list
(** [document json] is the pixels of a document of version 1. *)
