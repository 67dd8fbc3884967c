(** The rounds of loops. *)

val count :
  step_of:Expression.t -> first:float -> last:float -> step:float -> float
(** [count ~step_of ~first ~last ~step] is how many rounds lead from [first] to
    [last], the end included, with a tolerance of 1e-9 of a step: none if
    [step] leads away. A step of 0 raises {!Fault.Found} at [step_of]. *)

val value : first:float -> step:float -> float -> float
(** [value ~first ~step k] is that of round [k], counted from 0. *)
