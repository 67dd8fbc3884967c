(** Words of the trade, and of other programs, for those of the language. *)

val keywords : string -> string list
(** [keywords word] is what the scene language calls what others call [word],
    the likeliest first; nothing if [word] is not known. Case, hyphens and
    underscores do not matter. *)

val all : (string * string list) list
(** [all] is the words of the scene language, each with what others call that.
*)
