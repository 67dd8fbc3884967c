(** Words with their parameters, made ready to be evaluated. *)

open Raylab_source
open Raylab_geometry
open Raylab_expression

val number :
  Check.t ->
  Scope.t ->
  Number.rule ->
  string ->
  Expression.t ->
  float Check.ready
(** [number check scope rule name e] is [e], called [name]. *)

val color :
  Check.t ->
  Scope.t ->
  string ->
  Expression.t ->
  Raylab_scene.Color.t Check.ready
(** [color check scope name e] is the value of [e], a colour called [name]. *)

val compile :
  Check.t -> Scope.t -> Span.t -> default:'a -> 'a Written.t -> 'a Check.ready
(** [compile check scope span ~default w] is what [w], whose word is at [span],
    makes of its parameters; [default] after telling what is wrong with it, or
    if what it is part of is wrong already. *)
