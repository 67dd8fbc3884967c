(** Shapes as the leaves of a bounding volume hierarchy. *)

val of_shapes : Shape.t array -> Bvh_leaves.t
(** [of_shapes shapes] is those among [shapes] that have a box; each has the
    number that is its place there. *)

val spheres : Shape.t array -> int array -> float array
(** [spheres shapes numbers] is the x, y, z and radius of the sphere with each
    of [numbers], and of no meaning for other shapes; empty if there are no
    spheres. *)
