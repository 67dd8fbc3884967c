(** Convex hulls: the shortest way around points. *)

val of_points : Drawing.point list -> Drawing.point list
(** [of_points points] is the corners of the smallest convex polygon that holds
    [points], in order around it; at most two if they lie on a line (A. Andrew,
    {e Another efficient algorithm for convex hulls}, 1979). *)
