(** Numbers, and ranges of numbers. *)

val modulo : float -> float -> float
(** [modulo x d] is what is left of [x] when [d] is taken from it, or added to
    it, as often as it takes to come into the range from 0, inclusive, to [d],
    exclusive: never negative for a positive [d], never positive for a negative
    one. Only what has no double is rounded, to 0 if that would be [d]. NaN if
    [d] is 0 or [x] not finite. *)

val clamp : float -> float -> float -> float
(** [clamp x low high] is the number nearest to [x] from [low] to [high], where
    [low <= high]. *)

val mix : float -> float -> float -> float
(** [mix a b t] is [(1 - t) a + t b]: exactly [a] for 0, [b] for 1. *)

val smoothstep : float -> float -> float -> float
(** [smoothstep a b x] is 0 where [x] is before [a], 1 where it is after [b],
    and between them [3 t^2 - 2 t^3], where [t] is how far [x] has come. The
    way may lead down, from [a] to a lesser [b]. Where [a = b], it is 0 below
    and 1 from there on. *)
