(** What a shape is made of: the numbers and vectors that are written after its
    word. *)

type t = Number of float | Vector of Vec3.t  (** The type for parts. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] are the same part with equal numbers. *)
