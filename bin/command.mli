(** What the sub-commands share: arguments, and how they end. *)

(** {1 Messages} *)

val line : ('a, unit, string, unit) format4 -> 'a
(** [line "..." ...] prints a line on standard error, if that can be written
    to. It prints {!Raylab_source.Printable} characters only. *)

val say : ('a, unit, string, unit) format4 -> 'a
(** [say "..." ...] is {!line} with the name of the program before it. *)

val usage_errors : Format.formatter
(** [usage_errors] prints on standard error, and {!Raylab_source.Printable}
    characters only: what Cmdliner has to say about a command line, which may
    quote any bytes. *)

(** {1 Ends} *)

exception Ended of int
(** [Ended code] ends the program with the exit code [code]. What there is to
    say has been said. *)

val usage_error : ('a, unit, string, 'b) format4 -> 'a
(** [usage_error "..." ...] says on standard error what is wrong with the
    command line, and ends the program. *)

val write_error : string -> 'a
(** [write_error message] says on standard error that a picture could not be
    written, and ends the program. *)

val refuse : string list -> 'a
(** [refuse messages] says on standard error why bands are not joined, and ends
    the program. *)

(** {1 Scenes} *)

val scene_arg : string Cmdliner.Term.t
(** [scene_arg] is the positional argument SCENE. *)

val read_scene :
  allow:string list ->
  string ->
  Raylab_language.Scene_file.reading * Raylab_scene.Scene.t
(** [read_scene ~allow path] is the scene at [path], which may include files in
    the folders [allow], too, and all that was read for it; or it prints what
    is wrong with it on standard error and ends the program. *)

val handed_over : string -> Raylab_scene.Scene.t
(** [handed_over path] is the scene that the prompt has written there, or it
    says what is wrong with it and ends the program. *)

val is_same_file : string -> string -> bool
(** [is_same_file a b] is whether there is one file that both paths lead to. *)

val print_error : Raylab_language.Scene_error.t -> unit
(** [print_error error] prints [error] on standard error. *)

(** {1 Running} *)

val run : (unit -> unit) Cmdliner.Term.t -> int Cmdliner.Term.t
(** [run action] is the term whose value is the exit code of its action. An
    exception that nobody expected, whichever domain it comes from, is told in
    one line. *)

val info :
  ?version:string ->
  ?exits:Cmdliner.Cmd.Exit.info list ->
  string ->
  doc:string ->
  Cmdliner.Manpage.block list ->
  Cmdliner.Cmd.info
(** [info name ~doc man] is what the manual says about the program, or its
    sub-command, [name]. Its exit codes are {!Exit_code.infos}, or [exits]. *)
