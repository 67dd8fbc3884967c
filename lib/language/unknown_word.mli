(** What is said of a word that the language does not know. *)

val error :
  Source.t ->
  Span.t ->
  acceptable:(Parser.token -> bool) ->
  expected:string ->
  advice:string ->
  Scene_error.t
(** [error source span ~acceptable ~expected ~advice] is the error that the
    word at [span] is unknown where [expected] was, such as ["surface"].
    [advice] says more of that, and [acceptable] which tokens may stand there.
    If it is only a character that makes the word unknown, and one hardly sees
    it ({!Lookalike}), the error is that character. *)
