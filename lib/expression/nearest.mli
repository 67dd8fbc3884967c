(** What was probably meant by a word that is not known. *)

val find : string -> among:string list -> string option
(** [find word ~among] is the word of [among] that one reaches from [word],
    whatever its case, by the fewest insertions, deletions and replacements of
    a letter, if it takes no more of them than half the length of [word], or
    one. *)
