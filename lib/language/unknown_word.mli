(** What is said of a word that the language does not know. *)

open Raylab_source

val error :
  Sources.t ->
  Span.t ->
  acceptable:(Parser.token -> bool) ->
  names:string list ->
  expected:string ->
  advice:string ->
  habit:string ->
  Scene_error.t
(** [error sources span ~acceptable ~names ~expected ~advice ~habit] is the
    error that the word at [span] is unknown where [expected] was, such as
    ["surface"]. [advice] says more of that, [habit] what is written otherwise
    in other languages ({!Habit}), in the place of a suggestion, [acceptable]
    which tokens may stand there, and [names] which names are known. If it is
    only a character that makes the word unknown, and one hardly sees it
    ({!Lookalike}), the error is that character. *)
