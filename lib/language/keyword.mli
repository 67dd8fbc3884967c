(** The words of the scene language: one table, from which the lexer,
    suggestions, errors and the manual come. *)

(** What a word is for. *)
type role =
  | Setting
  | Heading
  | Light
  | Shape
  | Surface
  | Grouping
  | Modifier
  | Structure  (** reserved: never a name *)
  | Operator  (** reserved in brackets *)
  | Color

type parameter = {
  noun : string;  (** what stands there: ["number"] *)
  expected : string;  (** more of it, after ["expected "] *)
}
(** The type for what follows a word. *)

type t = {
  word : string;
  token : Parser.token;
  symbol : string;  (** the token in the grammar *)
  role : role;
  parameters : parameter list;
  doc : string;  (** what it is, in a line; [""] of colours *)
}
(** The type for words. *)

val table : t list
(** [table] is all words. *)

val words : role -> string list
(** [words role] is all words of [role], in the order of {!table}. *)

val all : (string * Parser.token) list
(** [all] is every keyword and colour name, as one writes it, with its token.
*)

val find : string -> t option
(** [find word] is the keyword or colour name [word], whatever its case;
    operators are not among them. *)

val token : string -> Parser.token option
(** [token word] is the token of {!find}[ word]. *)

val reserved_inside : string -> Parser.token option
(** [reserved_inside word] is the token of [word] if it is never a name in
    brackets. *)

val of_symbol : string -> t option
(** [of_symbol symbol] is the first word of this token. *)

val nearest : string -> among:string list -> string option
(** [nearest] is {!Raylab_expression.Nearest.find}. *)
