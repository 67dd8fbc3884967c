(** Arrays that grow as something is added. *)

(** Of integers. *)
module Ints : sig
  type t
  (** The type for growing arrays. *)

  val create : unit -> t
  (** [create ()] is a new one, empty. *)

  val length : t -> int
  (** [length ints] is how many there are. *)

  val get : t -> int -> int
  (** [get ints k] is the one at [k], from 0.

      Raises [Invalid_argument] if there is none. *)

  val add : t -> int -> unit
  (** [add ints i] adds [i] at the end. *)

  val clear : t -> unit
  (** [clear ints] forgets all, and keeps the space. *)

  val to_array : t -> int array
  (** [to_array ints] is all of them. *)
end

(** Of floats: the same. *)
module Floats : sig
  type t

  val create : unit -> t
  val length : t -> int
  val get : t -> int -> float
  val add : t -> float -> unit
  val to_array : t -> float array
end
