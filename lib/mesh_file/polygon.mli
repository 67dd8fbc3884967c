(** Polygons, cut into triangles. *)

val max_concave : int
(** [max_concave] is how many corners a polygon that is not convex may have,
    5,000: cutting one takes a time that grows with the square. *)

val cut :
  points:(int -> int -> float) ->
  count:int ->
  (int -> int -> int -> unit) ->
  bool
(** [cut ~points ~count triangle] cuts the polygon of [count] corners, at least
    three, of which [points k axis] is a coordinate of corner [k], and calls
    [triangle] with the three corners of each triangle, wound as the polygon
    is. There are [count - 2] of them.

    A convex polygon is cut into a fan from its first corner, any other by
    clipping ears (G. H. Meisters, {e Polygons have ears}, 1975), as it is seen
    along its normal. One that crosses itself is cut somehow. The result is
    false, and nothing is cut, if it is not convex and has more than
    {!max_concave} corners. *)
