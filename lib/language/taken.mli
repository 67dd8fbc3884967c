(** Names that take over words of the language. *)

type t = string * int
(** The type for them: the word, and the offset from which on it is a name. *)

val used_in_definition :
  Raylab_source.Sources.t ->
  before:int ->
  t list ->
  Raylab_source.Span.t option
(** [used_in_definition sources ~before taken] is the second place of a word of
    which there is nothing but [WORD = WORD] from where it became a name to the
    offset [before], if there is one: it was meant as a word in its own
    definition. *)

val warnings : t list -> Raylab_scene.Warning.t list
(** [warnings taken] is a warning of each of the first few. *)
