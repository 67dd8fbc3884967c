(** Points of a triangle. *)

val of_triangle : Vec3.t -> Vec3.t -> Vec3.t -> Vec3.t -> Vec3.t
(** [of_triangle p a b c] is the point of the triangle [a b c] that is nearest
    to [p]. *)
