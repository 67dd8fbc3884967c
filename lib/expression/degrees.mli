(** Sine, cosine and tangent of angles in degrees.

    Each result is within 0.9 units in the last place, 1.5 below 1e-300, and
    the nearest double wherever the exact one is a double: [sin 30.] is 0.5,
    [cos 90.] is 0, [tan 45.] is 1. Whole turns are taken off without any
    rounding, however large the angle. Of NaN and of infinities each is NaN.

    The series are Taylor's, up to 45 degrees, of an angle in radians that is
    known to twice the digits of a double; the second half comes in as it does
    in fdlibm (Sun Microsystems, 1993). For that arithmetic see T. J. Dekker,
    {e A floating-point technique for extending the available precision}, 1971;
    for whole turns, W. J. Cody and W. Waite,
    {e Software manual for the elementary functions}, 1980. *)

val sin : float -> float
(** [sin x] is the sine of [x] degrees. *)

val cos : float -> float
(** [cos x] is the cosine of [x] degrees. *)

val tan : float -> float
(** [tan x] is the tangent of [x] degrees; [infinity] where there is none, at
    all odd multiples of 90. *)
