(** How rays look. *)

(** The type for what they are drawn on. *)
type ground =
  | Paper  (** white *)
  | Picture
      (** of any colours: before it lines are brighter, with a dark rim *)

val ink : ground -> Path.kind -> int
(** [ink ground kind] is the colour of rays of this kind, as [0xRRGGBB]. *)

val words : ground -> Path.kind -> string
(** [words ground kind] says in a legend what they are. *)

val rimmed : ground -> Drawing.stroke -> Drawing.stroke list
(** [rimmed ground pen] is the pens with which [pen]'s lines are drawn, one
    after the other: with their rim, if they have one. *)

val line : ground -> Path.kind -> Drawing.point -> Drawing.point -> Drawing.t
(** [line ground kind a b] is a ray seen from [a] to [b]. *)

val cross : ground -> Drawing.point -> Drawing.t
(** [cross ground p] is a cross at [p], where a shadow ray is blocked. *)

val rim : int
(** [rim] is the colour of rims. *)
