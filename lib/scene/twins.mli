(** Objects that are where others are. *)

val warnings : Object.t list -> Warning.t list
(** [warnings objects] tells of each object that fills the place of one before,
    with whatever surface: the same plane twice, or the same sphere. *)
