(** Calls of functions. *)

val builtin : Builtin.t -> 'thing Value.func
(** [builtin f] is [f] as a value. *)

val of_value :
  'thing Frame.t ->
  Expression.t ->
  string ->
  ('thing Frame.t -> 'thing Value.t) Arguments.t ->
  'thing Value.t ->
  'thing Value.t
(** [of_value frame e name arguments f] is what the function [f], called [name]
    in the call [e], has for these arguments, evaluated in [frame]. *)

val of_builtin :
  Expression.t ->
  Builtin.t ->
  ('thing Frame.t -> 'thing Value.t) Arguments.t ->
  'thing Frame.t ->
  'thing Value.t
(** [of_builtin e f arguments frame] is the same of [f], which nothing shadows.
*)
