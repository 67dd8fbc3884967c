(** Arithmetic on brightness that stays finite.

    Brightness is never negative, so what can go wrong is overflow. Where a
    number would become infinite it becomes the largest finite double, and the
    product of anything with 0 stays 0: a colour is never infinite or NaN. *)

val limit : float -> float
(** [limit x] is [x], or [max_float] if [x] is greater, or 0 for NaN, which
    only 0 times an overflow gives. *)

val color : Color.t -> Color.t
(** [color c] is [c] with {!limit} applied to each channel. *)
