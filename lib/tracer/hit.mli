(** Hits: where a ray meets an object. *)

open Raylab_geometry

type t = {
  t : float;  (** the distance from the ray's origin *)
  point : Vec3.t;  (** the point of the object's surface *)
  normal : Direction.t;  (** the unit normal on the side the ray comes from *)
  offset : float;
      (** how far along [normal] a ray that leaves this point starts *)
}
(** The type for hits. *)

val make : offset:float -> Shape.t -> Ray.t -> t
(** [make ~offset shape ray] is the nearest hit of [ray] on [shape], which it is
    known to hit. [offset] is the scene's offset; the hit's is larger where that
    would be lost in the rounding errors of numbers as large as this hit's. *)

val start : t -> Vec3.t
(** [start hit] is the point from which rays leave: [point + offset * normal].
*)

val pp : Format.formatter -> t -> unit
(** [pp] prints [t = 5 at (0, 0, 1), normal (0, 0, -1)]. *)
