(** The powers of 2 with exponents 0, 1/32, ..., 31/32. *)

val high : float array
(** [high.(n)] is the double nearest to 2^[(n / 32)]. *)

val low : float array
(** [low.(n)] is what [high.(n)] lacks. *)
