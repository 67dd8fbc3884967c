(** Quads: parallelograms. *)

type t = private {
  corner : Vec3.t;
  edge : Vec3.t;
  other : Vec3.t;  (** the edges that begin at the corner *)
  end_of_edge : Vec3.t;
  far : Vec3.t;
  end_of_other : Vec3.t;  (** the other corners, all around *)
  normal : Direction.t;
  span : float;  (** {!Flat.span} *)
}
(** The type for quads: a corner and two edges, whose numbers are finite, and
    the direction of [edge x other]. *)

val make : corner:Vec3.t -> edge:Vec3.t -> other:Vec3.t -> t
(** [make ~corner ~edge ~other] is the quad with the corners [corner],
    [corner + edge], [corner + edge + other] and [corner + other].

    Raises [Invalid_argument] if a number of a corner is not finite, or the
    edges are parallel. *)

val name : string
(** [name] is the scene language's word, ["quad"]. *)

val parameters : t -> (string * Parameter.t) list
(** [parameters quad] is what is written after its word, in that order, each
    with its name: ["corner"], ["edge"] and ["other"]. *)

val corners : t -> Vec3.t list
(** [corners quad] is all four, all around. *)

(** {1 What is hit}

    The quad is the points [corner + u * edge + v * other] with [u] and [v]
    from 0 to 1. It is met as a triangle is ({!Triangle}), with four edges. *)

val offer : t -> Raw_ray.t -> Meeting.t -> number:int -> unit
(** [offer quad] is {!Shape.offer}. *)

val settle : t -> Raw_ray.t -> Spot.t -> unit
(** [settle quad] is {!Flat.settle}. *)

val crossings : t -> Raw_ray.t -> Crossings.t -> unit
(** [crossings quad] is {!Shape.crossings_raw}: none, or two at one distance.
*)

(** {1 What is told} *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [quad corner (0, 0, 6) edges (1, 0, 0) and (0, 1, 0)]. *)
