(** [raylab view]: a window that fills while the picture is rendered. *)

val cmd : int Cmdliner.Cmd.t
(** [cmd] is the sub-command. *)
