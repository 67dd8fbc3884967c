(** What those write who are used to other languages, and what they should
    write. *)

val advice :
  acceptable:(Parser.token -> bool) ->
  expected:string ->
  text:string ->
  Parser.token ->
  string option
(** [advice ~acceptable ~expected ~text token] is a sentence for who has
    written [text], which is [token], where [expected] was, such as ["number"],
    and the tokens that are [acceptable]. *)

val of_name : string -> string option
(** [of_name name] is a sentence for who uses a word of the language as a name
    in brackets. *)
