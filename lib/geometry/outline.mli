(** Outlines: what drawings and sentences about a shape need to know of it. *)

(** The type for outlines. *)
type t =
  | Ball of Sphere.t  (** round: a circle from every side *)
  | Endless of Plane.t  (** flat and without end *)
  | Patch of Vec3.t list
      (** flat: a convex piece of a plane, by its corners, all around *)
  | Body of Vec3.t list list
      (** solid: convex pieces of space, each by points that enclose it *)
  | Several of t list  (** these together *)
