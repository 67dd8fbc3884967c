(** Definitions, made ready to be evaluated. *)

open Raylab_expression

val compile :
  Evaluate_thing.block ->
  Check.t ->
  Scope.t ->
  Syntax.definition ->
  Scope.t * unit Check.ready
(** [compile block check scope d] is the scope after [d], and what gives the
    name its value. What is wrong with that is told. *)
