(** Errors in units in the last place. *)

val error : float -> high:float -> low:float -> float
(** [error x ~high ~low] is how far [x] is from [high + low], in units of the
    last place of [high], the double nearest to that. NaN if one is not finite.
*)
