(** A bounding volume hierarchy: finds what a ray hits among [n] shapes in
    about [log n] steps.

    The shapes that have a {!Shape.box} are the leaves of a binary tree; each
    inner node knows a box around each of its two subtrees, and a ray that
    misses a box misses all that is in it. Shapes without end are tested apart,
    for every ray. *)

val index : ?domains:int -> Shape.t array -> Finder.index
(** [index shapes] is an index over [shapes]. Its answers are those of
    {!Finder.brute_force}, bit for bit.

    (Bit for bit, as long as a ray starts within a million times as far from
    the origin as the shapes lie; beyond that rounding errors may let a ray
    pass beside the box of a shape whose edge it touches. A coordinate beyond
    about 1e154 cannot be squared, and a sphere there is not hit by either.)

    It is built in O(n log n), on at most [domains] domains, by default 1. It
    takes about 80 bytes for each shape. *)
