(** Names that take over words of the language. *)

type t = string * int
(** The type for them: the word, and the offset from which on it is a name. *)

val warnings : t list -> Raylab_scene.Warning.t list
(** [warnings taken] is a warning of each of the first few. *)
