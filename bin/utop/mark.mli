(** Byte-order marks, with which editors may begin a file of OCaml. *)

val without : string -> string
(** [without text] is [text] without the byte-order mark that it may start
    with. *)

val skip : Lexing.lexbuf -> unit
(** [skip lexbuf] goes on behind the byte-order mark that stands next in
    [lexbuf], if one does.

    Raises [Location.Error] if that is one of UTF-16. *)
