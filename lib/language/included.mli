(** Files that are included. *)

type t = Syntax.included

val nothing : t
(** [nothing] is in the place of a file that cannot be read. *)
