(** Items, made ready to be evaluated. *)

open Raylab_source
open Raylab_expression

val compile :
  Check.t ->
  Scope.t ->
  at:Span.t ->
  Syntax.item ->
  Scope.t * (Check.frame -> Sink.t -> unit)
(** [compile check scope ~at item] is the scope after [item], which stands in a
    block at [at], and what puts its lights and objects into a sink. What is
    wrong with them is told. *)

val block : Evaluate_thing.block
(** [block check scope ~at items frame sink] puts those of [items] into [sink],
    one after the other. Each item is a step, at [at]. *)
