(** [raylab render SCENE] and [raylab SCENE]. *)

val cmd : int Cmdliner.Cmd.t
(** [cmd] renders a scene to a file. *)

val default : int Cmdliner.Term.t
(** [default] is what raylab does without the name of a sub-command: what the
    program that it carries on did. It shows the picture, too, if there is a
    display. *)

val default_cmd : int Cmdliner.Cmd.t
(** [default_cmd] is {!cmd} with {!default} instead. *)
