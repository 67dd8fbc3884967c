(** Light: what reaches a spot from the lights that nothing blocks. A part of
    {!Evaluator}. *)

open Raylab_scene

val gather : Registers.t -> Raw_parts.t -> unit
(** [gather t highlights] puts the light that reaches the spot in its register
    into the register of light, and what of it shines in each of [highlights],
    of the surface there, into that of shine. It leaves the ray of the chain
    alone, and its meeting not. *)
