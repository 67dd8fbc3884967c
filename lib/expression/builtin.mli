(** The functions and names that every scene has.

    They are one table, from which evaluation, errors, suggestions and the
    manual come. *)

open Raylab_geometry

(** What a function takes and gives. [v] stands for a vector, [n] for a number,
    in the order of the parameters, the result last. *)
type body =
  | Number of (float -> float)
  | Number_2 of (float -> float -> float)
  | Number_3 of (float -> float -> float -> float)
  | Of_vector of (Vec3.t -> float)
  | Of_vectors of (Vec3.t -> Vec3.t -> float)
  | Vector of (Vec3.t -> Vec3.t)
  | Vectors of (Vec3.t -> Vec3.t -> Vec3.t)
  | To_vector of (float -> float -> float -> Vec3.t)
  | Vector_number of (Vec3.t -> float -> float)
  | Mix  (** of two numbers or two vectors *)
  | Count  (** the number of elements of a list *)
  | Nth  (** an element of a list *)

type t = {
  name : string;
  parameters : string list;
  doc : string;  (** what it is, one sentence: ["the sine of x degrees"] *)
  body : body;
}
(** The type for built-in functions. *)

val all : t list
(** [all] is the table, in the order of the manual. *)

val find : string -> t option
(** [find name] is the function of this name, in lower case. *)

val constants : (string * float * string) list
(** [constants] is the names of numbers, with their documentation. [time] is
    not among them. *)

val usage : t -> string
(** [usage f] is how [f] is written: ["atan2(y, x)"]. *)
