(** The schema of {!Json}, for people. *)

val text : string
(** [text] is the schema as the documentation of {!Json} has it. *)
