(** Crossings: all places where a line goes through the surface of a shape.

    A register, in which a shape writes the crossings of a ray's line, those
    behind its origin as well, in ascending order. A line passes from the
    outside of a solid to its inside and back by turns, so it takes one bit to
    tell of each crossing which it is. *)

type t = {
  mutable count : int;
  mutable starts_inside : bool;
      (** whether the line comes, from infinitely far away, in the inside of
          the shape, as half of all lines do in the half-space of a plane *)
  mutable distances : float array;  (** the first [count] are in use *)
  mutable parts : int array;  (** the part of the shape that is crossed *)
  mesh : Mesh_scratch.t;
}
(** The type for crossings of one line. *)

val create : unit -> t
(** [create ()] is a new register, of no crossings. *)

val clear : t -> starts_inside:bool -> unit
(** [clear crossings ~starts_inside] forgets all crossings. *)

val add : t -> part:int -> float -> unit
(** [add crossings ~part t] adds the crossing of [part] at distance [t], which
    is not less than that of the last one. *)

val divide : t -> float -> unit
(** [divide crossings length] makes each distance that of a ray which has to go
    1 where this one went [length], greater than 0. *)

val insert : t -> part:int -> float -> unit
(** [insert crossings ~part t] adds the crossing of [part] at distance [t]
    where it belongs among those that are there. *)

val enters : t -> int -> bool
(** [enters crossings k] is whether the line goes in at crossing [k], from 0.
*)

type crossing = { t : float; part : int; enters : bool }
(** A crossing. *)

val to_list : t -> crossing list
(** [to_list crossings] is all of them, in order. *)
