(** Large hostile texts, of any size. *)

val texts : (string * (int -> string)) list
(** [texts] is shapes of text, each with a name: [make n] is a text whose
    length grows with [n]. They nest deep, or have many lights, parts, errors
    or lines, or have very long words, numbers, comments and lines. *)

val growth : measure:(unit -> float) -> (int -> string) -> int -> float
(** [growth ~measure make n] is how many times as much, by [measure], of which
    differences are taken, it takes to read [make (4 * n)] as [make n]: about 4
    if it is linear. *)
