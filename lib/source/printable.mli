(** Texts that are safe to print. *)

val text : string -> string
(** [text s] is [s] with every character that is {!Character.is_unseen} and
    every byte that is not valid UTF-8 replaced by U+FFFD, so that a hostile
    file cannot reach the terminal's controls, and what is not seen elsewhere
    is seen. Tabs become spaces. *)
