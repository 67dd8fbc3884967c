(** Functions of a point, as data.

    What stands after the name of a point is kept as it is written, with the
    values of all other names in it: so it can be printed, compared and
    marshalled, and be evaluated anywhere. *)

open Raylab_geometry
open Raylab_source

(** The type for values that a name has. *)
type 'thing value =
  | Number of float
  | Truth of bool
  | Text of string
  | Vector of Vec3.t
  | List of 'thing value array
  | Function of string
      (** that of this name, which is defined before or built in *)
  | Thing of 'thing

(** The type for what defines a name. *)
type 'thing definition =
  | Value of 'thing value
  | Defined of { parameters : Expression.parameter list; body : Expression.t }
      (** a function, which may call itself *)

type 'thing t = {
  name : string;  (** of the point *)
  body : Expression.t;
  definitions : (string * 'thing definition) list;
      (** all names in [body] but that of the point and what is built in, each
          with what it uses before it; no two have the same name, nor that of
          something built in *)
}
(** The type for functions of a point. *)

val make :
  reserved:(string -> bool) ->
  thing:('a -> 'thing option) ->
  run:'a Value.run ->
  around:(string -> 'a Value.t option) ->
  at:Span.t ->
  string ->
  Expression.t ->
  'thing t
(** [make ~reserved ~thing ~run ~around ~at name body] is [body] as a function
    of the point [name]. [around] is what other names stand for there, [None]
    if they are built in. What the scene's things are in it is told by [thing],
    [None] if they cannot stand there. Names for which [reserved] holds, in
    lower case, or that stand for two things, get others.

    Raises {!Fault.Found} at [at] if a value cannot stand there, or has too
    many elements, and {!Fault.Known} if it has none. *)

val things : 'thing t -> 'thing list
(** [things closed] is those among the values. *)

val listed : 'thing t -> 'thing list
(** [listed closed] is those of them that are in lists. *)

val map : ('a -> 'b) -> 'a t -> 'b t
(** [map f closed] is [closed] with [f] applied to {!things}. *)

val equal : ('thing -> 'thing -> bool) -> 'thing t -> 'thing t -> bool
(** [equal equal_things a b] is whether [a] and [b] are written alike, with the
    same values. *)

(** {1 Evaluation} *)

type 'thing code
(** The type for functions made ready. Domains may share one. *)

val compile : 'thing t -> 'thing code
(** [compile closed] is [closed] made ready. *)

type 'thing machine
(** The type for evaluations. Each is used by one domain. *)

val start :
  describe:('thing -> string) ->
  make:
    ('thing Value.run ->
    Expression.t ->
    'thing Value.t array ->
    'thing Value.t) ->
  'thing code ->
  'thing machine
(** [start ~describe ~make code] evaluates [code]; see {!Value.run}. *)

val value : 'thing machine -> Vec3.t -> 'thing Value.t
(** [value machine point] is its value at [point], in {!Budget.pattern_steps}.

    Raises {!Fault.Found}; then {!trail} is what led there. *)

val trail : 'thing machine -> Trail.t
(** [trail machine] is the calls and rounds that are going on. *)

val run : 'thing machine -> 'thing Value.run
(** [run machine] is the evaluation, for {!Operation}. *)
