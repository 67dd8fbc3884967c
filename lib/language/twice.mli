(** Names that are defined twice in a block. *)

type t
(** The type for the names of a block that have been defined. *)

val start : Check.t -> t
(** [start check] is none. *)

val item : t -> Syntax.item -> unit
(** [item names item] notes what [item] defines, and tells if that is defined a
    second time. *)
