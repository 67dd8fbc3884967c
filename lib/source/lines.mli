(** Where the lines of a text are.

    This is known without the text, which may have become garbage. *)

type t
(** The type for indexes of lines: data, which can be compared and marshalled.
    A line takes a byte, or two if it has 128 bytes or more, and three from
    16,384 on. *)

val index : string -> t
(** [index text] is the index of [text], made in one pass. *)

val length : t -> int
(** [length index] is how many bytes the text has. *)

type line = {
  number : int;  (** counted from 0 *)
  start : int;  (** the offset of its first byte *)
  next : int;  (** the offset after its line end, or that of the text's end *)
}
(** A line of a text. A line feed ends it, a carriage return, or both, the
    carriage return first: what editors take for the end of a line. *)

val at : t -> int -> line
(** [at index offset] is the line of the byte at [offset], or of the end of the
    text, in a time that hardly depends on the text. *)
