(** Parameters: what is written after the word of a shape or a surface, one by
    one. *)

(** The type for parameters. *)
type t =
  | Number of float
  | Triple of float * float * float  (** a point, a vector or a colour *)
  | Text of string  (** in quotes: the name of a file, without a quote *)
  | Word of string  (** a word of the language *)

val of_vec3 : Vec3.t -> t
(** [of_vec3 v] is the triple of the components of [v]. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] are alike, with equal numbers. *)

val pp_with :
  (Format.formatter -> float -> unit) -> Format.formatter -> t -> unit
(** [pp_with pp_number] prints the numbers, each by [pp_number], with blanks
    between them; texts in quotes. *)
