(** Functions that a scene defines. *)

open Raylab_source

type parameter = Expression.parameter = {
  name : string;
  span : Span.t;
  default : Expression.t option;
}
(** The type for parameters as they are written. *)

val around : Scope.t -> 'thing Frame.t -> string -> 'thing Value.t option
(** [around scope frame name] is what [name] stands for where [scope] is known,
    in a call with this [frame]; [None] if it is built in.

    Raises {!Fault.Known} if it has no value. *)

val compile :
  Scope.t ->
  name:string ->
  ?written:Expression.t ->
  parameter list ->
  (Scope.t -> 'thing Code.t) ->
  'thing Code.t
(** [compile scope ~name ~written parameters body] is the function of
    [parameters] whose value is that of [body], in which they are known.
    [written] is [body] as an expression, if it is a value or a surface. *)
