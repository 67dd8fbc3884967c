(** How scenes lie in memory in this build of raylab. *)

val digest : string
(** [digest] is another one whenever that may be otherwise. *)
