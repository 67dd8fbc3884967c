(** Explanations for other programs, as JSON (RFC 8259).

    A document is an object [{ "version": 2, "pixels": [PIXEL, ...] }];
    {!Json_schema.text} says what a PIXEL is, and the rest. *)

open Raylab_tracer

val version : int
(** [version] is the version of the schema. *)

val of_ray : Explain.t -> Yojson.Safe.t
(** [of_ray e] is [e] as a RAY. *)

val document : Explain.pixel list -> Yojson.Safe.t
(** [document pixels] is the document about [pixels]. *)

val to_string : Yojson.Safe.t -> string
(** [to_string json] is [json] laid out for a reader, or, if it nests very
    deep, on one line; with a line end. *)
