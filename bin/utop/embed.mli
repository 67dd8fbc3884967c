(** Makes the module {!Embedded}. *)
