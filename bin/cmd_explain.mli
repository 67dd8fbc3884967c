(** [raylab explain]: why pixels have their colours. *)

val cmd : int Cmdliner.Cmd.t
(** [cmd] is the sub-command. *)
