(** Parameters of words, evaluated and checked.

    What is wrong with one is told, and the evaluation of the next ones goes
    on: one run finds every error. *)

open Raylab_geometry
open Raylab_scene
open Raylab_expression

type t
(** The type for what is known of the item that is being evaluated. *)

val start : Findings.t -> t
(** [start findings] tells [findings]. *)

val findings : t -> Findings.t
(** [findings check] is where errors are told. *)

type frame = Thing.t Code.frame

val attempt : t -> frame -> 'a -> (unit -> 'a) -> 'a
(** [attempt check frame default f] is [f ()], or [default] after telling what
    went wrong. What ends all evaluation is raised again. *)

val whole : t -> (unit -> 'a) -> 'a
(** [whole check build] is [build ()]. If anything in it was told to be wrong,
    it raises {!Raylab_expression.Fault.Known}. *)

type 'a parameter = frame -> 'a
(** The type for parameters, made ready to be evaluated. *)

val value : t -> Scope.t -> Expression.t -> Thing.t Value.t parameter
(** [value check scope e] is [e]; {!Raylab_expression.Value.Undefined} if it is
    wrong. *)

val number :
  t -> Scope.t -> Number.rule -> string -> Expression.t -> float parameter
(** [number check scope rule name e] is [e], called [name]. *)

val vector : t -> Scope.t -> string -> Expression.t -> Vec3.t parameter
(** [vector check scope name e] is a point or vector. *)

val direction : t -> Scope.t -> string -> Expression.t -> Vec3.t parameter
(** [direction check scope name e] is a vector that is not zero. *)

val color : t -> Scope.t -> string -> Expression.t -> Color.t parameter
(** [color check scope name e] is a colour, its channels not negative. *)
