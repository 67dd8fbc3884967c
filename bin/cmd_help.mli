(** [raylab help [COMMAND]] *)

val cmd : int Cmdliner.Cmd.t
(** [cmd] shows the manual of a command, or that of raylab. *)

val with_long_options : string list -> string list
(** [with_long_options arguments] is [arguments] with [--help] for [-h], of
    which Cmdliner does not know. *)
