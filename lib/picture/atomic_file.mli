(** Files that appear whole or not at all. *)

val save : path:string -> (string -> unit) -> (unit, string) result
(** [save ~path write] lets [write] fill a new file, whose name it is given,
    and makes it the file at [path]: it lies beside [path], is flushed to the
    disk and then renamed. If anything fails the result is a message that names
    [path] and the reason, and what was at [path] before is untouched. A
    symbolic link is followed. What is not a regular file, such as a device, is
    written to directly.

    [write] fails by raising [Sys_error], [Failure] or [Unix.Unix_error]. *)

val output : out_channel -> (string -> unit) -> (unit, string) result
(** [output channel write] lets [write] fill a temporary file, as {!save} does,
    copies it to [channel], in binary mode, and flushes that. A message names
    standard output. *)

val print : string -> (unit, string) result
(** [print text] writes [text] to standard output and flushes that. If this
    fails the result is a message, and standard output is closed, so that it
    cannot fail again when the program ends. *)

val temporary : unit -> string list
(** [temporary ()] is the files that a {!save} or {!output} under way would
    leave behind if the program ended now: what a signal handler has to remove.
*)
