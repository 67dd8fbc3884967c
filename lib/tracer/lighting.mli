(** Light: what reaches a hit from the lights that nothing blocks. A part of
    {!Evaluator}. *)

val gather : Registers.t -> unit
(** [gather t] puts the light that reaches the hit in its register into the
    register of light. *)
