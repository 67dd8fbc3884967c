(** How rays look. *)

(** The type for what they are drawn on. *)
type ground =
  | Paper  (** white *)
  | Picture
      (** of any colours: before it lines are brighter, with a dark rim *)

val ink : ground -> Path.kind -> Drawing.ink
(** [ink ground kind] is the colour of rays of this kind. *)

val words : ground -> Path.kind -> string
(** [words ground kind] says in a legend what they are. *)

val rim : Drawing.ink
(** [rim] is the colour of rims. *)

val lines :
  ground -> Drawing.stroke -> (Drawing.point * Drawing.point) list -> Drawing.t
(** [lines ground pen ends] is lines between [ends]: first all their rims, if
    they have some. *)

val line :
  ?tint:Raylab_scene.Color.t ->
  ground ->
  Path.kind ->
  Drawing.point ->
  Drawing.point ->
  Drawing.t
(** [line ~tint ground kind a b] is a ray seen from [a] to [b], in the colour
    of [tint] if that is one, by default white. *)

val cross : ground -> Drawing.point -> Drawing.t
(** [cross ground p] is a cross at [p], where a shadow ray is blocked. *)
