(** Straight lines in the window. *)

type point = float * float
type t = point * point

val clip : Box.t -> t -> t option
(** [clip box line] is the part of [line] that is in [box], in the same
    direction; [None] if there is none. *)

val dashes : t -> t list
(** [dashes line] is [line] cut into dashes of 6 pixels, 4 apart. *)
