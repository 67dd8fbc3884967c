(** Lights and objects, made ready to be evaluated. *)

open Raylab_source
open Raylab_expression

type block =
  Check.t ->
  Scope.t ->
  at:Span.t ->
  Syntax.item list ->
  Check.frame ->
  Sink.t ->
  unit
(** The type for what puts the items of a block into a sink. *)

val compile :
  block -> Check.t -> Scope.t -> Syntax.placed -> Check.frame -> Thing.t
(** [compile block check scope placed frame] is the light or object that
    [placed] writes, where its modifiers put it; [block] evaluates groups. What
    is wrong raises {!Raylab_expression.Fault.Found}, or is told and raises
    {!Raylab_expression.Fault.Known}. *)
