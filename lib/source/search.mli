(** Searching among what lies one after another. *)

val last_from : ('a -> int) -> 'a array -> int -> int
(** [last_from start items offset] is the index of the last of [items] that
    starts at [offset] or before. Items are in the order of [start], and the
    first starts there; there is at least one. *)
