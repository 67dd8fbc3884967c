(** Spots: all that is known of the place where a ray hits a shape.

    A register. The shape writes point, normal, own point and size into it
    ({!Shape.settle}), the tracer then side and offset. *)

type t = {
  mutable x : float;
  mutable y : float;
  mutable z : float;  (** the point of the shape *)
  mutable nx : float;
  mutable ny : float;
  mutable nz : float;
      (** the unit normal, of the flat surface: outward as the shape writes it,
          after {!turn_to} on the side from which the ray comes *)
  mutable shading_x : float;
  mutable shading_y : float;
  mutable shading_z : float;
      (** the unit normal by which light is reckoned: that of the surface, but
          on a smooth mesh *)
  mutable own_x : float;
  mutable own_y : float;
  mutable own_z : float;
      (** the point in the shape's own coordinates, in which it was written
          down; exactly on the shape, so that a coordinate which is the same
          all over it has that value *)
  mutable size : float;
      (** the largest of the shape's numbers that went into the point, besides
          its coordinates: the radius of a sphere, 0 of a plane *)
  mutable side : float;
      (** 1 if the ray comes from the side of the outward normal, -1 if it
          comes from the other *)
  mutable offset : float;
      (** how far off the surface a ray that leaves it starts *)
}
(** The type for spots. *)

val create : unit -> t
(** [create ()] is a new register. What it holds is no spot of anything. *)

val of_point : point:Vec3.t -> normal:Direction.t -> offset:float -> t
(** [of_point ~point ~normal ~offset] is a spot at [point], of a shape of no
    size, seen from the side of [normal]. *)

(** {1 Writing} *)

val set_point : t -> float -> float -> float -> unit
(** [set_point spot x y z] is the spot at (x, y, z). *)

val set_own : t -> float -> float -> float -> unit
(** [set_own spot x y z] makes (x, y, z) its own point. *)

val set_normal : t -> float -> float -> float -> unit
(** [set_normal spot x y z] makes (x, y, z), of length 1, its normal, and the
    one for shading. *)

val set_shading_normal : t -> float -> float -> float -> unit
(** [set_shading_normal spot x y z] makes (x, y, z), of length 1, the normal
    for shading only. *)

val turn_to : t -> Raw_ray.t -> unit
(** [turn_to spot ray] turns the outward normal to the side from which [ray]
    comes, and notes which that is. A normal at right angles to [ray] stays.
    The normal for shading is turned with it, and is the same where it would
    face away from [ray]. *)

(** {1 Reading} *)

val is_smooth : t -> bool
(** [is_smooth spot] is whether its normal for shading is another than that of
    the surface. *)

val start : t -> Raw_ray.t -> unit
(** [start spot ray] makes [ray] start off the surface, on the side of the
    normal: at [point + offset * normal]. *)

val start_behind : t -> Raw_ray.t -> unit
(** [start_behind spot ray] makes [ray] start off the surface on the other
    side: at [point - offset * normal]. *)

val reflect : t -> Raw_ray.t -> unit
(** [reflect spot ray] turns [ray] into the one that a mirror at [spot] makes
    of it: without end, from {!start} along [d - 2 (d . n) n], where [n] is the
    normal for shading, and the side to which it points makes no difference. A
    smooth mesh may send it through the surface: then it starts on the other
    side. Its length is 1 within rounding, however many times it is reflected.
*)

val point : t -> Vec3.t
(** [point spot] is the point. *)

val own : t -> Vec3.t
(** [own spot] is the own point. *)

val normal : t -> Direction.t
(** [normal spot] is the normal. *)

val shading : t -> Direction.t
(** [shading spot] is the normal for shading. *)
