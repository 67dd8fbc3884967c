(** The schema of {!Json}, for people. *)

val text : string
(** [text] says what a PIXEL of a document is, and all that it is made of. *)
