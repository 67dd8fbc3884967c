(** Expressions, made ready to be evaluated many times.

    An expression becomes a function of the frame that holds the values of its
    names: every name has been looked up then. *)

open Raylab_source

type 'thing t = 'thing Frame.t -> 'thing Value.t
(** The type for what evaluates an expression. It raises {!Fault.Found} or
    {!Fault.Known}. *)

val compile : Scope.t -> Expression.t -> 'thing t
(** [compile scope e] evaluates [e]. A name that [scope] does not know is told
    once, by its {!Scope.type-report}. *)

val number : Scope.t -> Expression.t -> 'thing Frame.t -> float
(** [number scope e] evaluates [e], which must be a number. *)

val truth : Scope.t -> Expression.t -> 'thing Frame.t -> bool
(** [truth scope e] evaluates [e], which must be a truth value. *)

(** {1 Loops} *)

val loop :
  Scope.t ->
  at:Span.t ->
  string ->
  Span.t ->
  Expression.range ->
  Scope.t * ('thing Frame.t -> (unit -> unit) -> unit)
(** [loop scope ~at name span range] is the scope of the body of a loop over
    [range], which knows [name], introduced at [span], and what does something
    once for each round, with the value of the round in the frame. Each round
    is a step, at [at], and stands on the stack of the run meanwhile. *)
