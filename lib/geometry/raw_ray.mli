(** Rays whose numbers can be overwritten.

    The tracer follows millions of rays. It keeps the one that it is at in a
    register of this type, where storing a double allocates nothing. Everywhere
    else rays are {!Ray.t}, which is this type with no way to change it. *)

type t = {
  mutable ox : float;
  mutable oy : float;
  mutable oz : float;  (** the origin *)
  mutable dx : float;
  mutable dy : float;
  mutable dz : float;  (** the direction, of length 1 *)
  mutable reach : float;  (** hits at this distance or beyond do not count *)
  mutable seed : float;
      (** a number on which may depend what is placed at random; 0 for a ray
          that is made by hand *)
  mutable share : float;
      (** how much the ray counts in the colour of the first: 1 of that, and
          less of a ray that was sent on together with others *)
}

val create : unit -> t
(** [create ()] is a new register. Its numbers are those of no ray. *)

val set_origin : t -> float -> float -> float -> unit
(** [set_origin ray x y z] makes [ray] start at (x, y, z). *)

val set_direction : t -> float -> float -> float -> unit
(** [set_direction ray x y z] makes [ray] go along (x, y, z), whose length must
    be 1. *)

val end_x : t -> float
(** [end_x ray] is the x of the point at the end of [ray]'s reach. *)

val end_y : t -> float
(** [end_y ray] is its y. *)

val end_z : t -> float
(** [end_z ray] is its z. *)
