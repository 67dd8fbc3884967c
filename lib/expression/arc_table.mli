(** The angles, in degrees, whose tangents are 0, 1/16, ..., 16/16. *)

val high : float array
(** [high.(n)] is the multiple of 2^-44 nearest to the angle with tangent
    [n / 16], so that it can be added to right angles without rounding. *)

val low : float array
(** [low.(n)] is what [high.(n)] lacks. *)
