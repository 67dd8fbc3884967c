(** Fixed numbers that look random. *)

val stir : int -> int
(** [stir h] has 30 bits, of which the higher ones depend on all those of [h];
    [h] may be any number. It is quick, and good enough between {!pick} and
    what is to be added next. *)

val pick : int -> int -> int
(** [pick n h] is one of 0, ..., [n - 1], each as often as the others if all
    [h] of 30 bits are; [n] is at most 2^15. *)

val mix : int -> int
(** [mix h] is [h], of 30 bits, as a number of 30 bits that looks unlike it;
    those of any two [h] differ. It is the finaliser of MurmurHash3 (A.
    Appleby, 2011) for 30 bits, with multipliers that were searched for:
    turning over one bit turns over each other one in half of the cases, as far
    as can be measured. *)

val random : float -> float
(** [random k] is a number from 0, inclusive, to 1, exclusive, a multiple of
    2^-53: for each [k] the same everywhere and always, and in no visible way
    like that of any other [k]. 0 and -0 are one number; of NaN and infinities
    it is NaN. *)
