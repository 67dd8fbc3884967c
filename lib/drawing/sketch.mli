(** What is drawn in a panel, before its labels have places. *)

type t = {
  marks : Drawing.t;
  busy : Rectangle.t list;  (** what labels should not cover *)
  labels : Label.t list;  (** the first are the most important *)
}
(** The type for sketches. *)

val marks : Drawing.t -> t
(** [marks drawing] is [drawing] alone. *)

val busy : Rectangle.t -> Drawing.t -> t
(** [busy r drawing] is [drawing], of which no label should cover what is in
    [r]. *)

val label : Label.t -> t
(** [label l] is [l] alone. *)

val all : t list -> t
(** [all list] is all that is in [list]. *)

val finish : Rectangle.t -> t -> Drawing.t
(** [finish panel s] is [s] in [panel]: the marks, and above them the labels,
    as {!Label.arrange} has them. *)
