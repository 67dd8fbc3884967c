(** What was probably meant by a word that the language does not know. *)

val sentence :
  acceptable:(Parser.token -> bool) -> names:string list -> string -> string
(** [sentence ~acceptable ~names word] asks whether one of the words was meant
    that are [acceptable] where [word] stands: ["Did you mean 'diffusive'?"].
    It is [""] if there is nothing to suggest.

    A number with a decimal comma, or several with commas between them, is
    meant for numbers; a word of the trade ({!Synonym}) for ours, of which the
    sentence speaks even where it may not stand; any other for the
    {!Keyword.nearest}, of the [names] that are known as well. *)
