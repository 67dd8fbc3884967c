(** The words of the scene language. *)

val token : string -> Parser.token option
(** [token word] is the token of the keyword or colour name [word], whatever
    its case. *)

val nearest : string -> among:string list -> string option
(** [nearest word ~among] is the word of [among] that one reaches from [word],
    whatever its case, by the fewest insertions, deletions and replacements of
    a letter, if it takes no more of them than half the length of [word], or
    one. *)

val all : (string * Parser.token) list
(** [all] is every keyword and colour name, as one writes it, with its token.
*)
