(** What many runs come to. *)

val minimum : float list -> float
(** [minimum xs] is the least of [xs], NaN if there is none. Of times, it is
    the one that other programs on the machine disturbed least. *)

val median : float list -> float
(** [median xs] is the middle of [xs] in order, or the mean of the two in the
    middle; NaN if there is none. *)

val worst :
  (float -> float -> bool) -> ('a * float) list -> ('a * float) option
(** [worst is_worse named] is the first of [named] than whose number no other
    [is_worse]. NaN, which stands for what was not measured, is left out. *)
