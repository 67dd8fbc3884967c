(** Drawings as SVG 1.1.

    Numbers have one digit after the point, and those of places far outside are
    cut off. U+FFFD stands for what XML cannot hold: control characters and
    bytes that are not UTF-8. *)

val document : Sheet.t -> string
(** [document sheet] is an SVG file that shows [sheet]. *)

val mark : Drawing.mark -> string
(** [mark m] is the element that shows [m]. Words have a white rim that keeps
    them legible. *)
