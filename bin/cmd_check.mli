(** [raylab check SCENE...] *)

val cmd : int Cmdliner.Cmd.t
(** [cmd] reads scenes and reports errors and warnings. *)
