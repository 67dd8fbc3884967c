(** Where the prompt keeps what was typed. *)

val file : unit -> string option
(** [file ()] is [raylab/history] in the user's directory for state
    ([$XDG_STATE_HOME], or [~/.local/state]), which it makes; [None] if there
    is no home, or it cannot be made. *)
