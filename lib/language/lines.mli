(** Where the lines of a text are. *)

type t
(** The type for indexes of lines. One takes some thousandths of the memory of
    its text, however short the lines are. *)

val index : string -> t
(** [index text] is the index of [text], made in one pass. *)

type line = {
  number : int;  (** counted from 0 *)
  start : int;  (** the offset of its first byte *)
  stop : int;  (** the offset of its line end, or of the text's end *)
}
(** A line of a text. A line feed ends it, a carriage return, or both, the
    carriage return first: what editors take for the end of a line. *)

val at : t -> int -> line
(** [at index offset] is the line of the byte at [offset], or of the end of the
    text, in constant time, however long the lines are. *)
