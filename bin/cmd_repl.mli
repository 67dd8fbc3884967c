(** [raylab repl [SCENE] [SCRIPT]] *)

val cmd : int Cmdliner.Cmd.t
(** [cmd] becomes the prompt, which is a program of its own. *)
