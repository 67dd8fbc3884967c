(** How the lines of rays look. *)

val ink : Path.kind -> string
(** [ink kind] is the colour of rays of this kind, as CSS has it. *)

val style : Path.kind -> string
(** [style kind] is the attributes of their lines. *)

val cross : Svg.point -> Svg.t list
(** [cross p] is a cross at [p], where a shadow ray is blocked. *)

val way : Svg.point -> Svg.point -> float * (float * float)
(** [way a b] is the distance from [a] to [b], and the way of length 1 in that
    direction. *)

val head : string -> Svg.point -> float * float -> Svg.t
(** [head ink tip way] is an arrow head of which [tip] is the front and [way],
    of length 1, the direction. *)
