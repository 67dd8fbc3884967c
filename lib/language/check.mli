(** Evaluation that goes on after errors.

    What is wrong with a parameter is told, and the evaluation of the next ones
    goes on: one run finds every error. *)

open Raylab_expression

type t
(** The type for what is known of the item that is being evaluated. *)

val start : Findings.t -> t
(** [start findings] tells [findings]. *)

val findings : t -> Findings.t
(** [findings check] is where errors are told. *)

type frame = Thing.t Frame.t

val failed : t -> bool
(** [failed check] is whether anything in the innermost {!whole} is wrong. *)

val attempt : t -> frame -> 'a -> (unit -> 'a) -> 'a
(** [attempt check frame default f] is [f ()], or [default] after telling what
    went wrong. What ends all evaluation is raised again. *)

val whole : t -> (unit -> 'a) -> 'a
(** [whole check build] is [build ()]. If anything in it was told to be wrong,
    it raises {!Raylab_expression.Fault.Known}. *)

type 'a ready = frame -> 'a
(** The type for what is made ready to be evaluated. *)
