(** From text to syntax. *)

val parse : Source.t -> (Syntax.t, Scene_error.t) result
(** [parse source] is the scene that [source] writes, its numbers unchecked, or
    the first place where it is not in the language. It takes time linear in
    the size of the text and raises nothing, whatever the bytes. *)
