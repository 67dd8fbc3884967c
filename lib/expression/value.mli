(** Values: what expressions have. *)

open Raylab_geometry
open Raylab_source

(** The type for values. ['thing] is what else a name may stand for, such as
    surfaces: this room knows no scene. *)
type 'thing t =
  | Number of float  (** always finite *)
  | Truth of bool
  | Text of string
  | Vector of Vec3.t  (** a point, a vector or a colour; a list of 3 numbers *)
  | List of 'thing t array
      (** any other list; see {!list}. Nobody changes the array. *)
  | Function of 'thing func
  | Thing of 'thing
  | Undefined
      (** none: that of a name whose definition failed, and of an argument that
          is not given *)

and 'thing func = {
  name : string;
  parameters : parameter array;
  call : 'thing run -> 'thing t array -> 'thing t;
      (** with an argument for each parameter, {!Undefined} where an optional
          one is not given *)
}
(** The type for functions. *)

and parameter = { label : string; optional : bool }

and 'thing run = {
  budget : Budget.t;
  describe : 'thing -> string;  (** the kind of a thing: ["a surface"] *)
  mutable stack : 'thing frame list;
      (** the calls and rounds that are going on, the innermost first; after a
          {!Fault}, those that led to it *)
}
(** The type for evaluations that are going on, each in one domain. *)

and 'thing frame =
  | Call of {
      name : string;
      arguments : (string * 'thing t) list;
      at : Span.t;
    }
  | Round of { name : string; value : 'thing t; at : Span.t }  (** of a loop *)

val list : 'thing t array -> 'thing t
(** [list elements] is the value of these elements: a {!Vector} if they are
    three numbers. *)

val elements : 'thing t -> 'thing t array option
(** [elements value] is the elements of a list or vector. *)

val kind : ('thing -> string) -> 'thing t -> string
(** [kind describe value] is what [value] is: ["a number"]. *)

val pp_with : ('thing -> string) -> Format.formatter -> 'thing t -> unit
(** [pp_with describe] prints [2.5], [true], ["a"], [[1, 0, 0]], the first
    elements of a list, the name of a function, and the {!kind} of a thing. *)

val to_string : ('thing -> string) -> 'thing t -> string
(** [to_string describe value] is what {!pp_with} prints. *)

val equal : step:(unit -> unit) -> 'thing t -> 'thing t -> bool option
(** [equal ~step a b] is whether [a] and [b] are the same number, truth value,
    text or list; [None] if they are of two kinds, or of one that is not
    compared. An element makes a list so only if those before it are equal.
    [step] is called for each two values that are compared. *)
