(** Clipping lines to a rectangle, as Liang and Barsky do (1984).

    A line is the points [from + t * step] for [t] in a range; it is in a
    rectangle where each coordinate is between two numbers. *)

val narrow :
  float * float -> from:float -> step:float -> float -> float -> float * float
(** [narrow (first, last) ~from ~step low high] is the [t] from [first] to
    [last] for which [from + t * step] lies between [low] and [high]. If there
    is none the first of the result is greater than the second. *)

val segment :
  Rectangle.t ->
  Drawing.point * Drawing.point ->
  (Drawing.point * Drawing.point) option
(** [segment r (a, b)] is the part of the line from [a] to [b] that is in [r],
    in the same direction; [None] if there is none. *)
