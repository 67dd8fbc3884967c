(** Expressions as they are written: what stands in brackets in a scene. *)

open Raylab_source

type parameter = { name : string; span : Span.t; default : t option }
(** The type for parameters of functions. *)

and t = { desc : desc; span : Span.t }
(** The type for expressions, each with its place. *)

and desc =
  | Number of float
  | Truth of bool
  | Text of string
  | Name of string  (** as written; case does not matter *)
  | Call of { name : string; name_span : Span.t; arguments : argument list }
  | Triple of t * t * t
      (** three numbers without brackets around them, or more generally a
          vector whose parts must be numbers *)
  | List of t list
  | Series of { name : string; name_span : Span.t; range : range; body : t }
      (** [[for NAME ...: EXPR]] *)
  | Part of t * char  (** [e.x]; the letter in lower case *)
  | Negative of t
  | Not of t
  | Binary of operator * t * t
  | If of t * t * t
  | Let of { name : string; name_span : Span.t; value : t; body : t }
  | Word of { word : string; arguments : (position * t) list }
      (** a surface, in a pattern: a word with what stands after it *)
  | Varying of { name : string; name_span : Span.t; body : t }
      (** a surface in a pattern, with the name of the point *)

(** What stands somewhere without brackets around it. *)
and position = Number | Color | Weight | Surface

and range = To of { first : t; last : t; step : t option } | In of t
and argument = { label : (string * Span.t) option; value : t }

and operator =
  | Add
  | Subtract
  | Multiply
  | Divide
  | Power
  | Equal
  | Different
  | Less
  | Less_or_equal
  | Greater
  | Greater_or_equal
  | And
  | Or

val bare_triple : t -> t -> t -> t
(** [bare_triple x y z] is the {!Triple} of these, from the first to the last.
*)

val symbol : operator -> string
(** [symbol operator] is how it is written: ["<="]. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints the expression on one line, with no more brackets than it
    needs. Read again it has the same parts. *)

val pp_bare : Format.formatter -> position * t -> unit
(** [pp_bare ppf (position, e)] prints a blank and then [e] as it stands where
    such a thing is wanted. *)

val to_string : t -> string
(** [to_string e] is what {!pp} prints. *)
