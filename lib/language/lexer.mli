(** Words of the scene language.

    White space and comments separate words and are not seen. Outside of
    brackets every run of other characters, up to a bracket or an equals sign,
    is one token: a number, a name, a keyword, a colour name, or, if it is none
    of these, a [WORD], which no rule of the grammar takes. In brackets it is
    an ordinary language of expressions, where all words but the reserved ones
    are names.

    A word that a definition, a loop or a parameter introduces is a name from
    there to the end of the block around it, whatever else it means. So is one
    that a file defines which is included. *)

open Raylab_source

type files = {
  include_ : Span.t -> string -> Syntax.included;
      (** reads a file that is included: its name, and where that stands *)
  mesh : Span.t -> string -> Raylab_mesh_file.Model.t;
      (** reads the file of a mesh, likewise *)
}
(** The type for what reads other files. *)

type state
(** The type for what was read before: names, blocks, brackets. *)

val start : ?files:files -> unit -> state
(** [start ~files ()] is the state at the start of a text. By default every
    file that is included is empty, and every mesh a triangle. *)

val token : state -> Lexing.lexbuf -> Parser.token
(** [token state buffer] is the next token. It raises nothing, whatever the
    bytes. *)

val names : state -> string list
(** [names state] is the names that are known, in lower case; at the end of a
    text those that it defines. *)

val too_deep : state -> (int * string) option
(** [too_deep state] is the first offset where more than 1,000 brackets or
    blocks are open, or more than 1,000 operators stand between two brackets or
    commas, and what is said of it. *)

val taken : state -> (string * int) list
(** [taken state] is the words of the language that became names, in the order
    of the text, with their offsets. *)
