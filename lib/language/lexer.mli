(** Words of the scene language.

    White space and comments separate words and are not seen. Every run of
    other characters is one token: a number, a keyword, a colour name, or, if
    it is none of these, a [WORD], which no rule of the grammar takes. *)

val token : Lexing.lexbuf -> Parser.token
(** [token buffer] is the next token. It raises nothing, whatever the bytes. *)
