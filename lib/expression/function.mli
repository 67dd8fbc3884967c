(** Functions that a scene defines. *)

open Raylab_source

type parameter = {
  name : string;
  span : Span.t;
  default : Expression.t option;
}
(** The type for parameters as they are written. *)

val compile :
  Scope.t ->
  name:string ->
  parameter list ->
  (Scope.t -> 'thing Code.t) ->
  'thing Code.t
(** [compile scope ~name parameters body] is the function of [parameters] whose
    value is that of [body], in which they are known. *)
