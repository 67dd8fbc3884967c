(** How warnings are worded. *)

val at : int option list -> string -> string
(** [at lines text] is [text] with the lines of what it speaks of, as far as
    they are known: ["text (lines 4 and 9)"]. *)

val few : string -> ('a -> string) -> 'a list -> string list
(** [few noun tell items] tells the first ten of [items], and how many more
    there are, [noun] being what one is: ["3 more lights are like that"]. *)

val name : int -> Object.t -> string
(** [name number o] is what object [number] is called: ["sphere 3"]. *)
