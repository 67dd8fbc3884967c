(** Lines that are broken where a reader would break them. *)

val at_words :
  (Format.formatter -> 'a -> unit) -> Format.formatter -> 'a -> unit
(** [at_words pp ppf x] prints what [pp] prints of [x], each line of it broken
    at the margin of [ppf], but only before a word or an operator with a word:
    numbers stay with the word that they follow, and what is in parentheses
    stays together. What follows a break stands further to the right. *)
