(** What is wrong with scenes, for other programs, as JSON (RFC 8259). *)

open Raylab_language

val version : int
(** [version] is the version of the schema. *)

val schema : string
(** [schema] says what the document is, for people. *)

val document : (string * Problem.t list) list -> Yojson.Safe.t
(** [document scenes] is the document about these paths of scenes and what was
    found in each. *)
