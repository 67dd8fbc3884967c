(** How far off a surface the rays start that leave it.

    Else they would meet the surface that they leave, for a computed point lies
    beside its surface by a rounding error. *)

val of_scale : float -> float
(** [of_scale scale] is the usual offset where the lengths of a scene are of
    the size of [scale]: [1e-5 * scale]. The original's offset is 1e-5, which
    suits lengths of a few units. *)

val rounding : float
(** [rounding] is 2^-44: so much of the numbers that go into a point its
    rounding error is less than. *)

val lift : usual:float -> Spot.t -> Raw_ray.t -> unit
(** [lift ~usual spot ray] sets the offset of [spot], where the end of [ray]
    lies on a shape: [usual], or, if that is more, 2^-44 times the sum of the
    numbers that went into the point, those of [ray]'s origin, the point and
    the shape's size. A smaller one would be lost in rounding. *)

(** {1 Where doubles end} *)

val farthest : float
(** [farthest] is 2^1022: no spot lies farther out, nor its own point, so that
    what is computed from it is finite. *)

val within : float -> float
(** [within x] is the coordinate [x], not beyond {!farthest}. *)
