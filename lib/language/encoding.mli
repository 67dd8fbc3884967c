(** Texts that are not UTF-8. *)

val foreign : string -> string option
(** [foreign text] is the name of the encoding of [text], ["UTF-16"] or
    ["UTF-32"], if it starts with the byte-order mark of one, or with letters
    of ASCII as such an encoding has them. *)
