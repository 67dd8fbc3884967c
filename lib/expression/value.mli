(** Values: what expressions have. *)

open Raylab_geometry

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
  source : 'thing source;
}
(** The type for functions. *)

(** What a function is made of, for patterns, which are data. *)
and 'thing source =
  | Built_in  (** its name is all that there is to say *)
  | Written of {
      parameters : Expression.parameter list;
      body : Expression.t;
      around : string -> 'thing t option;
          (** what a name is where the function is defined; [None] if it is
              built in *)
    }
  | Unwritten  (** what it makes is no value and no surface *)

and parameter = { label : string; optional : bool }

and 'thing run = {
  budget : Budget.t;
  describe : 'thing -> string;  (** the kind of a thing: ["a surface"] *)
  make : 'thing run -> Expression.t -> 'thing t array -> 'thing t;
      (** what the {!Expression.Word} makes of its arguments *)
  mutable trail : Trail.t;
      (** the calls and rounds that are going on; after a {!Fault}, those that
          led to it *)
  mutable point : Vec3.t;  (** that of the {!Expression.Varying} *)
}
(** The type for evaluations that are going on, each in one domain. *)

val list : 'thing t array -> 'thing t
(** [list elements] is the value of these elements: a {!Vector} if they are
    three numbers. *)

val elements : 'thing t -> 'thing t array option
(** [elements value] is the elements of a list or vector. *)

val kind : ('thing -> string) -> 'thing t -> string
(** [kind describe value] is what [value] is: ["a number"]. *)

val datum : ('thing -> string) -> 'thing t -> Datum.t
(** [datum describe value] is [value] as it is told: of a list the first
    elements, of lists in lists in lists and of things the {!kind}. *)

val to_string : ('thing -> string) -> 'thing t -> string
(** [to_string describe value] is {!Datum.to_string} of that. *)

val equal : step:(unit -> unit) -> 'thing t -> 'thing t -> bool option
(** [equal ~step a b] is whether [a] and [b] are the same number, truth value,
    text or list; [None] if they are of two kinds, or of one that is not
    compared. An element makes a list so only if those before it are equal.
    [step] is called for each two values that are compared. *)
