(** The natural logarithms of the 64ths from 45/64, just below the root of 1/2,
    to 91/64, just above the root of 2. *)

val first : int
(** [first] is 45. *)

val high : float array
(** [high.(n - first)] is the multiple of 2^-42 nearest to the logarithm of
    [n / 64], so that it can be added to small multiples of such a number
    without rounding. *)

val low : float array
(** [low.(n - first)] is what [high.(n - first)] lacks. *)
