(** Which argument of a call belongs to which parameter. *)

open Raylab_source

type 'a t
(** The type for the arguments of a call; ['a] is what evaluates one. *)

val make : (Expression.argument * 'a) list -> 'a t
(** [make arguments] is these, in the order in which they are written. *)

val arrange :
  Span.t -> name:string -> Value.parameter array -> 'a t -> 'a option array
(** [arrange span ~name parameters arguments] is the argument of each of
    [parameters] of the function [name]; those without a label come first, in
    order. Raises {!Fault.Found}, at the argument or at the call [span], if one
    is too much, is given twice, has a label that the function does not know,
    or is missing. *)
