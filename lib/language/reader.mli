(** From text to syntax. *)

open Raylab_source

type parsed = {
  included : Syntax.included;
  taken : Taken.t list;  (** in the order of the text *)
}
(** The type for what is read of a file. *)

val parse :
  ?files:Lexer.files ->
  Sources.t ->
  Sources.file ->
  (parsed, Scene_error.t) result
(** [parse ~files sources file] is what [file], one of [sources], writes, its
    numbers unchecked, or the first place where it is not in the language.
    Other files come from [files], which may be called twice for each. It takes
    time linear in the size of the text and raises nothing, whatever the bytes.
*)
