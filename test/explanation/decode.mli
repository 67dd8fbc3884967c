(** Explanations from JSON, by the schema that [Json] documents.

    What does not follow it raises {!Decode_scene.Wrong}. *)

open Raylab_tracer

type pixel = {
  rgb : int * int * int;
  summary : string;
  explanation : Explain.pixel;
}

val document : Yojson.Safe.t -> pixel list
(** [document json] is the pixels of a document of the version that [Json]
    writes. *)
