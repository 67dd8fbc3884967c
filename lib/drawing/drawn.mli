(** What is drawn in a panel: shapes, and the labels of these. *)

type t = {
  shapes : Svg.t list;  (** the first farthest back *)
  marks : Rectangle.t list;  (** what labels should not cover *)
  labels : Label.t list;  (** the first are the most important *)
}
(** The type for drawings. *)

val shapes : Svg.t list -> t
(** [shapes list] is [list] alone. *)

val mark : Rectangle.t -> Svg.t list -> t
(** [mark r list] is [list], of which no label should cover what is in [r]. *)

val label : Label.t -> t
(** [label l] is [l] alone. *)

val all : t list -> t
(** [all list] is all that is in [list]. *)

val draw : View.t -> t -> Svg.t list
(** [draw view d] is [d] in the panel of [view]: the shapes, and above them the
    labels, as {!Label.arrange} has them. *)
