(** Light: what reaches a spot from the lights that nothing blocks. A part of
    {!Evaluator}. *)

val gather : Registers.t -> unit
(** [gather t] puts the light that reaches the spot in its register into the
    register of light. It leaves the ray of the chain alone, and its meeting
    not. *)
