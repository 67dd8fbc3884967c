(** Expressions, made ready to be evaluated many times.

    An expression becomes a function of the frame that holds the values of its
    names: every name has been looked up then. *)

open Raylab_source

type 'thing frame = {
  mutable slots : 'thing Value.t array;
  outer : 'thing frame;  (** of the function around; of the outermost itself *)
  run : 'thing Value.run;
}
(** The type for frames: the values of the names of a call that goes on. *)

type 'thing t = 'thing frame -> 'thing Value.t
(** The type for what evaluates an expression. It raises {!Fault.Found} or
    {!Fault.Known}. *)

val start : 'thing Value.run -> size:int -> 'thing frame
(** [start run ~size] is the outermost frame. *)

val need : 'thing frame -> int -> unit
(** [need frame size] gives [frame] at least [size] slots. *)

val set : Scope.binding -> 'thing frame -> 'thing Value.t -> unit
(** [set binding frame value] gives the name its value, in the frame of the
    function in which it is bound. *)

(** {1 Expressions} *)

val compile : Scope.t -> Expression.t -> 'thing t
(** [compile scope e] evaluates [e]. A name that [scope] does not know is told
    once, by its {!Scope.type-report}. *)

val number : Scope.t -> Expression.t -> 'thing frame -> float
(** [number scope e] evaluates [e], which must be a number. *)

val truth : Scope.t -> Expression.t -> 'thing frame -> bool
(** [truth scope e] evaluates [e], which must be a truth value. *)

(** {1 Loops} *)

val rounds :
  Scope.t ->
  Span.t ->
  Expression.range ->
  'thing frame ->
  ('thing Value.t -> unit) ->
  unit
(** [rounds scope span range] gives the value of each round of [range] to a
    function, one after the other. Each round is a step. *)

(** {1 Functions} *)

type parameter = {
  name : string;
  span : Span.t;
  default : Expression.t option;
}
(** The type for parameters as they are written. *)

val func :
  Scope.t ->
  name:string ->
  parameter list ->
  (Scope.t -> 'thing t) ->
  'thing frame ->
  'thing Value.t
(** [func scope ~name parameters body] is the function of [parameters] whose
    value is that of [body], in which they are known. *)
