(** Decimal numbers, read fast. *)

val of_bytes : bytes -> first:int -> stop:int -> float
(** [of_bytes text ~first ~stop] is the double nearest to the decimal number in
    [text] from byte [first] up to, not including, byte [stop]: what
    [float_of_string] makes of it. The number must have the form that the scene
    language gives to numbers: a sign, digits with a point, an exponent.

    Most numbers in files have few digits: at most 15, or 9 where ints have 32
    bits, and a power of ten up to 10^22 are both exact as doubles, and one
    multiplication or division of exact numbers is rounded correctly (W. D.
    Clinger, {e How to read floating point numbers accurately}, 1990). Others
    are left to [float_of_string]. *)
