(** The exit codes of raylab. *)

val ok : int
(** 0 *)

val scene_error : int
(** 1: the scene is in error *)

val refused : int
(** 1: bands do not make a picture *)

val not_written : int
(** 2: a picture or other output could not be written, or not shown, or a job
    not submitted *)

val usage : int
(** 124: the command line is wrong *)

val failed : int
(** 125: memory ran out, or raylab itself is in error *)

val interrupted : int
(** 130: interrupted by Ctrl-C *)

val hung_up : int
(** 129: the terminal went away *)

val terminated : int
(** 143: ended by a signal to terminate *)

val quit : int
(** 131: asked to quit, by SIGQUIT *)

val out_of_time : int
(** 152: the limit of the time of the processor is reached *)

val unread : int
(** 141: the reader of the output went away *)

val infos : Cmdliner.Cmd.Exit.info list
(** [infos] is the section EXIT STATUS of the manual pages. *)
