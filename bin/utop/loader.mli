(** Where the prompt finds the interfaces of modules. *)

val install : unit -> unit
(** [install ()] makes the type checker look among {!Embedded.interfaces}
    before it looks for a file. *)
