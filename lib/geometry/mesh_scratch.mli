(** Scratch space for shapes that have a hierarchy of their own.

    It is part of the registers into which shapes write what is met, and of no
    meaning in between. *)

type t = {
  stack : int array;  (** nodes that are still to be visited *)
  mutable top : int;  (** the place of the last of them *)
  sheared : Triangle_ray.t;  (** the ray, for triangles *)
}
(** The type for scratch space. *)

val max_depth : int
(** [max_depth] is how deep a hierarchy may be: no node has more inner nodes
    above it. *)

val create : unit -> t
(** [create ()] is new scratch space. *)
