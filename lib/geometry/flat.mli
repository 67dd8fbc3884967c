(** What is flat: the mathematics that discs, triangles and quads share with
    planes. A plane is given by one of its points and its normal. *)

val distance : Vec3.t -> Direction.t -> Raw_ray.t -> float
(** [distance point normal ray] is where the line of [ray] meets the plane: at
    [(point - o) . n / d . n]. For a parallel line it is infinite, or NaN if
    the line lies in the plane. *)

val distance_near : Vec3.t -> Direction.t -> float -> Raw_ray.t -> float
(** [distance_near point normal span ray] is {!distance}, or NaN where the
    place is farther than [span] from [point], the sum of the coordinates'
    distances. So what rounding lets pass for a piece of the plane, seen from
    so far away that all of it is one point in doubles, is not met. *)

val is_across : float -> float -> bool
(** [is_across a b] is whether a plane lies across an axis, so that all its
    points have one coordinate there, where [a] and [b] are the other two
    numbers of its normal. The third is 1 within rounding only. *)

val settle : Vec3.t -> Direction.t -> Raw_ray.t -> Spot.t -> unit
(** [settle point normal ray spot] is {!Shape.settle} for a piece of the plane:
    the spot is the point of the plane that is nearest to the end of [ray], of
    size 0. *)

val cross : float -> Crossings.t -> unit
(** [cross t crossings] is {!Shape.crossings_raw} of what is met at distance
    [t], which is infinite or NaN where there is nothing to meet: the line goes
    in and out at once. *)

val normal : Vec3.t -> Vec3.t -> Direction.t option
(** [normal u v] is the direction of [u x v]; [None] if there is none, since
    [u] and [v] are parallel to 12 digits, or one of them has no direction. *)

val span : Vec3.t -> Vec3.t -> float
(** [span u v] is farther than any point of the piece with the edges [u] and
    [v] is from the corner where they begin, as {!distance_near} measures it.
*)

val side :
  Raw_ray.t -> float -> float -> float -> float -> float -> float -> float
(** [side ray x y z x' y' z'] is on which side of the line of [ray] the edge
    from (x, y, z) to (x', y', z') passes: with [p] and [q] the ways from the
    origin to its ends, [d . (p + q) x (p - q)], with [p - q] from the ends
    themselves. That is twice the volume [d . p x q] with the other sign, but
    with fewer digits lost, and the same edge the other way round has exactly
    the opposite number, so that no line passes between two pieces that share
    it (I. Wald and others,
    {e Embree: a kernel framework for efficient CPU ray tracing}, 2014). *)

(** {1 Where it is} *)

val place : Vec3.t list -> float array
(** [place corners] is the numbers of [corners], in an order that does not
    depend on theirs. *)
