(** Triangles. *)

type t = private {
  a : Vec3.t;
  b : Vec3.t;
  c : Vec3.t;
  normal : Direction.t;
  span : float;
}
(** The type for triangles: three corners, whose coordinates are finite, and
    the direction of [(b - a) x (c - a)]. *)

val make : Vec3.t -> Vec3.t -> Vec3.t -> t
(** [make a b c] is the triangle with these corners.

    Raises [Invalid_argument] if a coordinate is not finite, or the corners lie
    on one line. *)

val name : string
(** [name] is the scene language's word, ["triangle"]. *)

val parameters : t -> (string * Parameter.t) list
(** [parameters triangle] is what is written after its word, in that order,
    each with its name: ["a"], ["b"] and ["c"]. *)

val corners : t -> Vec3.t list
(** [corners triangle] is all three. *)

(** {1 What is hit}

    The triangle is the points [a + u (b - a) + v (c - a)] with [u, v >= 0] and
    [u + v <= 1]. The line of a ray meets the plane of the triangle
    ({!Flat.distance}), and the triangle if all edges, one after the other,
    pass on the same side of it: if no two of the three {!Flat.side} have
    different signs. So the rim belongs to the triangle, and of two triangles
    that share an edge a line meets at least one there. *)

val offer : t -> Raw_ray.t -> Meeting.t -> number:int -> unit
(** [offer triangle] is {!Shape.offer}. *)

val settle : t -> Raw_ray.t -> Spot.t -> unit
(** [settle triangle] is {!Flat.settle}. *)

val crossings : t -> Raw_ray.t -> Crossings.t -> unit
(** [crossings triangle] is {!Shape.crossings_raw}: none, or two at one
    distance. *)

(** {1 What is told} *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [triangle a (0, 0, 6) b (1, 0, 6) c (0, 1, 6)]. *)
