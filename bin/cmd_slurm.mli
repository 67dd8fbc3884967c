(** [raylab slurm SCENE -o OUT --bands N] *)

val cmd : int Cmdliner.Cmd.t
(** [cmd] writes a job for Slurm, and submits it if asked to. *)
