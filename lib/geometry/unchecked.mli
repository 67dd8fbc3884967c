(** Arrays of numbers in inner loops, read without a check of the place. *)

val ( .%() ) : float array -> int -> float
(** [a.%(i)] is [a.(i)] without the check that [i] is a place of [a]: only for
    places that are right by construction. A check costs the inner loops about
    a sixth of their time. *)
