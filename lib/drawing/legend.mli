(** What the lines in a picture of a path mean. *)

val draw : Svg.point -> Svg.t list
(** [draw corner] explains the kinds of rays, in one line. *)

val width : float
(** [width] is how wide that is. *)
