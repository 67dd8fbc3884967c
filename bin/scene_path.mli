(** Where a scene comes from. A stream, such as standard input or a pipe, can
    be read once, and no picture can be called after it. *)

val is_stream : string -> bool
(** [is_stream path] is whether a scene at [path] comes from a stream. *)

val name : string -> string
(** [name path] is how messages call [path]. *)

val picture :
  ?format:Raylab_picture.Picture_file.format ->
  string ->
  (string, string) result
(** [picture ~format path] is where the picture of the scene at [path] goes if
    nothing else is said, {!Output.beside}, or a message that asks for a name.
*)
