(** Pieces of arithmetic whose bits are known.

    What is made of these and of [+. -. *. /.] and [sqrt] gives the same bits
    in native code, in bytecode and in JavaScript. One trap is left: some
    processors multiply and add in one instruction with one rounding, and on
    them OCaml does so wherever a product is written as an operand of a sum or
    of a difference. So it never is here; it has a name of its own, or stands
    in {!mul_add} or {!sub_mul}. *)

val mul_add : float -> float -> float -> float
(** [mul_add a b c] is [a b + c], the product and the sum rounded each. *)

val sub_mul : float -> float -> float -> float
(** [sub_mul c a b] is [c - a b], the product and the difference rounded each.
*)

val head : float -> float
(** [head x] is [x] rounded to 26 bits, and [x -. head x] what is left, which
    has 26 bits, too: products of heads are exact. From 2^996 on it is NaN (T.
    J. Dekker,
    {e A floating-point technique for extending the available precision}, 1971;
    the splitting is G. W. Veltkamp's). *)

val nearest : float -> float
(** [nearest x] is the whole number nearest to [x], the even one of two, for
    [x] from -2^51 to 2^51. *)

val scale : float -> int -> float
(** [scale x e] is [x] times 2^[e], rounded once where it is subnormal; [e] is
    from -2148 to 2046. *)

val exponent : float -> int
(** [exponent x] is the [e] with 2^[e <= x <] 2^[(e + 1)], for a finite
    positive [x]. *)
