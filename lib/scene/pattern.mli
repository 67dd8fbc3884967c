(** The evaluation of surfaces and colours that are functions of a point. *)

open Raylab_source
open Raylab_geometry
open Raylab_expression

type failure = {
  fault : Fault.t;
  trail : Trail.t;  (** the calls and rounds that led to it *)
  point : Vec3.t;  (** where the pattern has no value *)
}
(** The type for what goes wrong. *)

exception Failed of failure
(** Raised in place of a value. *)

val told : Files.t -> ?pixel:int * int -> failure -> string * string list
(** [told files ~pixel failure] is what is wrong, and lines that say more: the
    calls that led to it, the point, the pixel, and what to do. *)

(** {1 Machines} *)

type 'thing make =
  'thing Value.run -> Expression.t -> 'thing Value.t array -> 'thing Value.t
(** The type for what words make of their arguments. *)

val start : make:'thing make -> 'thing Closed.code -> 'thing Closed.machine
(** [start ~make code] evaluates [code]. *)

val value :
  'thing Closed.machine ->
  Vec3.t ->
  ('thing Value.run -> 'thing Value.t -> 'a) ->
  'a
(** [value machine point read] is what [read] makes of the value at [point].

    Raises {!Failed} if it has none, or [read] raises
    {!Raylab_expression.Fault.Found}. *)

(** {1 Reading values}

    Each raises {!Raylab_expression.Fault.Found} where a value is not of its
    kind, or against its rule; [e] is where it comes from. *)

val number :
  Number.rule ->
  string ->
  'thing Value.run ->
  Expression.t ->
  'thing Value.t ->
  float
(** [number rule name run e value] is the number [value], called [name], which
    obeys [rule]. *)

val color :
  string -> 'thing Value.run -> Expression.t -> 'thing Value.t -> Color.t
(** [color name run e value] is the colour [value], called [name]. *)
