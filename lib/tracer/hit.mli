(** Hits: where a ray meets an object. *)

open Raylab_geometry

type t = {
  number : int;  (** of the object, by its place in the scene, from 1 *)
  primitive : int option;
      (** which primitive of it, from 1, if it is a solid *)
  part : int;
      (** of its shape, or of that of the primitive, by the shape's own count
      *)
  t : float;  (** the distance from the ray's origin *)
  point : Vec3.t;  (** the point of the object's shape *)
  own_point : Vec3.t;  (** the same in the shape's own coordinates *)
  normal : Direction.t;  (** the unit normal on the side the ray comes from *)
  shading : Direction.t option;
      (** on a smooth mesh the one by which light is reckoned, if that is
          another *)
  outside : bool;
      (** whether that is the side of the shape's outward normal *)
  offset : float;
      (** how far along [normal] a ray that leaves this point starts *)
}
(** The type for hits. *)

val of_registers :
  primitive:int option -> part:int -> Meeting.t -> Spot.t -> Raw_ray.t -> t
(** [of_registers ~primitive ~part meeting spot ray] is the hit of this part
    that they hold: [ray] ends at it. *)

val start : t -> Vec3.t
(** [start hit] is the point from which rays leave: [point + offset * normal].
*)

val pp_normal : Format.formatter -> t -> unit
(** [pp_normal] prints [(0, 0, -1)], or
    [(0, 0, -1), smoothed to (0.6, 0, -0.8)]. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [t = 5 at (0, 0, 1), normal (0, 0, -1)]. *)
