(** A bounding volume hierarchy: finds what a ray hits among [n] spheres in
    about [log n] steps.

    The spheres are the leaves of a binary tree; each inner node knows a box
    around each of its two subtrees, and a ray that misses a box misses all that
    is in it. Planes have no box: they are tested apart, for every ray. *)

val index : ?domains:int -> Shape.t array -> Query.index
(** [index shapes] is an index over [shapes]. Its answers are those of
    {!Query.brute_force}, bit for bit.

    It is built in O(n log n), on at most [domains] domains, by default 1. It
    takes about 100 bytes for each sphere. *)
