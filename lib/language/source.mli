(** Source texts: a scene file's name and bytes, and the places in it. *)

open Raylab_source

type t
(** The type for source texts. *)

val make : name:string -> string -> t
(** [make ~name text] is the source [text], without the byte-order mark that it
    may start with. [name] is what errors call it. *)

val name : t -> string
(** [name source] is its name, with {!printable} characters only. *)

val text : t -> string
(** [text source] is all its bytes. *)

type place = {
  line : int;  (** counted from 1 *)
  first : int;  (** the column of the first byte, counted from 1 *)
  last : int;  (** the column of the last byte; at least [first] *)
}
(** Where a span is. Columns count bytes. *)

val place : t -> Span.t -> place
(** [place source span] is where [span] is. An empty span, or one that goes on
    in another line, gets at least one column of its first line. *)

val slice : t -> Span.t -> string
(** [slice source span] is the text of [span], byte for byte. *)

val quote : t -> Span.t -> string
(** [quote source span] is the text of [span], {!printable} and shortened where
    it is long. *)

val next_word : t -> int -> Span.t
(** [next_word source offset] is the first word that starts at [offset] or
    after it, comments left out; the empty span at the end of the text if there
    is none. *)

val excerpt : t -> Span.t -> string * int * int
(** [excerpt source span] is [(line, before, length)]: the {!printable} text of
    the line on which [span] starts, or the part around [span] of a long line,
    and the place of [span] in it, in characters. *)

val printable : string -> string
(** [printable text] is [text] with every character that is
    {!Character.is_unseen} and every byte that is not valid UTF-8 replaced by
    U+FFFD, so that a hostile file cannot reach the terminal's controls, and
    what is not seen elsewhere is seen. Tabs become spaces. *)
