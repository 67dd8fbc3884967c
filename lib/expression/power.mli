(** The exponential function, its inverse, and powers.

    Each result is within 0.53 units in the last place, 0.8 where it is
    subnormal, and the nearest double wherever the exact one is a double:
    [pow 10. 15.] is 1e15.

    The method is that of P. T. P. Tang,
    {e Table-driven implementation of the exponential function in IEEE
       floating-point arithmetic}, 1989, and
    {e ... of the logarithm function ...}, 1990: a table near the number, and a
    short series for the rest. Logarithms have twice the digits of a double,
    after T. J. Dekker, 1971, which powers need. *)

val exp : float -> float
(** [exp x] is e^[x]: [infinity] from about 709.78 on, 0 below about -745.13,
    NaN of NaN. *)

val log : float -> float
(** [log x] is the natural logarithm of [x]: [neg_infinity] of 0, NaN of
    negative numbers and of NaN. *)

val pow : float -> float -> float
(** [pow x y] is [x]^[y]: 1 if [y] is 0, whatever [x]; NaN if [x] is negative
    and [y] not a whole number; [infinity] if [x] is 0 and [y] negative, or
    where the result is too large, then [neg_infinity] if it is negative; NaN
    if [x] or [y] is NaN, unless [y] is 0 or [x] is 1. *)
