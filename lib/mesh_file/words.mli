(** The words of a text, line by line. *)

type t
(** The type for texts that are being read. *)

val start : ?at:int -> ?line:int -> string -> t
(** [start ~at ~line text] is [text] from its byte [at] on, in line [line]; by
    default from the start, in line 1. *)

val line : t -> int
(** [line words] is the line of the last word, counted from 1. *)

val place : t -> Fault.place
(** [place words] is the place of the last word. *)

val next_line : t -> bool
(** [next_line words] goes to the start of the next line; false at the end of
    the text. A line feed ends a line, a carriage return or both. *)

val next : t -> bool
(** [next words] goes to the next word of the line; false if there is none, and
    from [#] on. A backslash before the end of a line makes the next line go on
    with it. *)

val next_anywhere : t -> bool
(** [next_anywhere words] is {!next}, in this line or a later one. *)

val back : t -> unit
(** [back words] makes the last word the next one again. *)

val position : t -> int
(** [position words] is the byte where the next word is looked for. *)

val left : t -> int
(** [left words] is how many bytes there are from there on. *)

(** {1 The word} *)

val is : t -> string -> bool
(** [is words word] is whether the word is [word], in whatever case it is; the
    letters of [word] are small. *)

val raw : t -> string
(** [raw words] is the word, byte for byte. *)

val text : t -> string
(** [text words] is the word, shortened where it is long, in quotes, and of
    {!Raylab_source.Printable} characters: for messages. *)

val number : t -> float
(** [number words] is the word as a number. It is a fault if it is none, or too
    large for a double. *)

val next_number : t -> string -> float
(** [next_number words what] goes to the next word and is its {!number}. It is
    a fault if there is none: [what] is missing. *)

val integer : t -> int
(** [integer words] is the word as an integer of at most nine digits, with or
    without a sign. It is a fault if it is none. *)

val integers : t -> separator:char -> Growing.Ints.t -> unit
(** [integers words ~separator ints] makes [ints] those of the word, with a
    [separator] between them: [1/2/3]. One that is not there, as in [1//3], is
    {!missing}. *)

val missing : int
(** [missing] is no integer that can be read. *)
