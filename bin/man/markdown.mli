(** A page in Markdown, as far as [doc/language.md] needs it. *)

type block =
  | Heading of int * Prose.t  (** its level, from 1 on *)
  | Paragraph of Prose.t
  | Verbatim of string list  (** fenced or indented: its lines *)
  | Items of Prose.t list
  | Table of { header : Prose.t list; rows : Prose.t list list }

val parse : string list -> (block list, string) result
(** [parse lines] is the blocks of the page, or a message that names the line
    of the first block with something that is not known here. *)
