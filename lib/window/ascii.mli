(** Words for windows, whose fonts have nothing but ASCII. *)

val of_utf_8 : string -> string
(** [of_utf_8 text] is [text], in UTF-8, with a question mark for each
    character that is not printable ASCII. Line ends stay. *)

val wrap : columns:int -> rows:int -> string -> string list
(** [wrap ~columns ~rows text] is the lines of {!of_utf_8}[ text], broken where
    they are longer than [columns], at blanks if possible. Of more than [rows]
    lines, the last that is there says that there is more. *)
