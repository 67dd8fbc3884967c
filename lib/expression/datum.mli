(** Values as they are told: data without functions, of a bounded size. *)

open Raylab_geometry

type t =
  | Number of float
  | Truth of bool
  | Text of string
  | Vector of Vec3.t
  | List of { first : t list; count : int }
      (** its first elements, and how many there are in all *)
  | Other of string
      (** the name of a function, or what anything else is: ["a surface"] *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [2.5], [true], ["a"], [[1, 0, 0]], the first elements of a list
    and how many there are, and the words of all else. *)

val to_string : t -> string
(** [to_string datum] is what {!pp} prints. *)
