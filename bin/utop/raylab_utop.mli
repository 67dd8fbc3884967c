(** [raylab-utop [SCENE] [SCRIPT]] is what [raylab repl] becomes. An empty
    argument is none. *)
