(** [raylab join PART... -o OUT] *)

val cmd : int Cmdliner.Cmd.t
(** [cmd] puts bands together. *)
