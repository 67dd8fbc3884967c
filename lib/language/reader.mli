(** From text to syntax. *)

open Raylab_source

val parse : Sources.t -> Sources.file -> (Syntax.t, Scene_error.t) result
(** [parse sources file] is the scene that [file], one of [sources], writes,
    its numbers unchecked, or the first place where it is not in the language.
    It takes time linear in the size of the text and raises nothing, whatever
    the bytes. *)
