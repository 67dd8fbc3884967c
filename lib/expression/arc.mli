(** Angles in degrees, from their sine, cosine or tangent.

    Each result is within 0.52 units in the last place, and the nearest double
    wherever the exact one is a double: [asin 0.5] is 30, [atan 1.] is 45; only
    angles below about 1e-58 degrees are within 1.9. A zero has no sign. Of NaN
    each is NaN.

    The angle from a table and that from a series are added as in P. T. P.
    Tang,
    {e Table-lookup algorithms for elementary functions and their error
       analysis}, 1991, with quotients and roots to twice the digits of a
    double after T. J. Dekker, 1971. *)

val atan2 : float -> float -> float
(** [atan2 y x] is the angle from -180, exclusive, to 180 between the x axis
    and the point ([x], [y]); 0 if both are 0, NaN if both are infinite. *)

val atan : float -> float
(** [atan x] is the angle from -90 to 90 whose tangent is [x]. *)

val asin : float -> float
(** [asin x] is the angle from -90 to 90 whose sine is [x]. What is up to 1e-9
    beyond -1 or 1 is taken for that; of what is farther it is NaN. *)

val acos : float -> float
(** [acos x] is the angle from 0 to 180 whose cosine is [x], with the bounds of
    {!asin}. *)
