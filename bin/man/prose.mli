(** The text of a Markdown page, as far as [doc/language.md] needs it. *)

type piece =
  | Plain of string
  | Code of string
  | Strong of string
  | Picture of { shows : string; file : string }

type t = piece list
(** The type for texts. Line ends are those of the page, and a link is the text
    that it has. *)

exception Unknown of string
(** Of what is no such text, in words. *)

val parse : targets:(string * string) list -> string -> t
(** [parse ~targets markdown] is the text that is written [markdown], where
    [[name]] stands for the target that [targets] has for it. Raises
    {!Unknown}. *)
