(** Smooth noise in space.

    Gradient noise after K. Perlin, {e Improving noise}, 2002, with his twelve
    directions and his polynomial. Directions are not from a table of 256 but
    from a hash of the place in the lattice, so that the noise never seems to
    repeat; it does after 2^30. *)

val noise : float -> float -> float -> float
(** [noise x y z] is a number from -1 to 1, 0 on the average and rarely beyond
    0.6. It waves about once from a place to that 1 away, and is twice
    differentiable. The lattice does not contain the origin, so that points
    with whole coordinates have noise as others have. NaN if a coordinate is
    not finite. *)

val turbulence : float -> float -> float -> int -> float
(** [turbulence x y z octaves] is a number from -1 to 1: the mean of [octaves]
    noises, each twice as fine as the one before it and half as heavy. With 1
    it is {!noise}, with less than 1 it is 0, and beyond 32 it is that of 32.
*)
