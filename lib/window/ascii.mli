(** Words for windows, whose fonts have nothing but ASCII. *)

val of_utf_8 : string -> string
(** [of_utf_8 text] is [text], in UTF-8, with a question mark for each
    character that is not printable ASCII. Line ends stay. *)
