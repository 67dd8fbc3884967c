(** A bounding volume hierarchy: finds what a ray hits among [n] shapes in
    about [log n] steps.

    The shapes that have a {!Shape.box} are the leaves of a binary tree; each
    inner node knows a box around each of its two subtrees, and a ray that
    misses a box misses all that is in it. Shapes without a box are not in it:
    see {!Endless}. *)

type t
(** The type for hierarchies. *)

val make : ?domains:int -> Shape.t array -> t
(** [make shapes] is that over [shapes]. What is found in it is what trying one
    shape after the other finds, bit for bit.

    (Bit for bit, as long as a ray starts within a million times as far from
    the origin as the shapes lie; beyond that rounding errors may let a ray
    pass beside the box of a shape whose edge it touches. A coordinate beyond
    about 1e154 cannot be squared, and a sphere there is not hit by either.)

    It is built in O(n log n), on at most [domains] domains, by default 1. It
    takes about 80 bytes for each shape. *)

(** {1 Questions} *)

type walk
(** Where a search is; each domain needs one of its own. *)

val make_walk : unit -> walk
(** [make_walk ()] is a new one. *)

val nearest : t -> walk -> Raw_ray.t -> Meeting.t -> unit
(** [nearest bvh walk ray meeting] lets the shapes that [ray] can hit nearer
    than what it is known to hit offer where they are met. *)

val some : t -> walk -> Raw_ray.t -> Meeting.t -> unit
(** [some bvh walk ray meeting] is the same until one is met. *)

val cost : t -> float
(** [cost bvh] is about how many inner nodes a ray that crosses all of it
    visits if it hits nothing, and the tests of shapes, in the same unit. *)

(** {1 In the order of its leaves} *)

val numbers : t -> int array
(** [numbers bvh] is the numbers of its shapes. *)

val spheres : t -> float array
(** [spheres bvh] is the x, y, z and radius of each of them that is a sphere,
    and of no meaning for others; nothing if none is one. *)
