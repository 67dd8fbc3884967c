(** Patterns: what is kept as a function of a point. *)

open Raylab_source
open Raylab_scene
open Raylab_expression

val make :
  thing:(Thing.t -> Surface.t option) ->
  Scope.t ->
  at:Span.t ->
  string ->
  Expression.t ->
  Check.frame ->
  Surface.t Closed.t
(** [make ~thing scope ~at name e frame] is [e] as a function of the point
    [name], with the values that [frame] has for other names; see
    {!Raylab_expression.Closed.make}. *)

val surface : Thing.t -> Surface.t option
(** [surface thing] is [thing] if it is a surface. *)
