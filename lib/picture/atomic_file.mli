(** Files that appear whole or not at all. *)

(** {1 Files} *)

type outcome = Regular_file.outcome =
  | Whole  (** the file came into its place in one step *)
  | In_place of string
      (** it had to be copied over what was there, for this reason: it is a
          mount point, or its folder does not let it be replaced *)

val save : path:string -> (out_channel -> unit) -> (outcome, string) result
(** [save ~path write] lets [write] fill a new file and makes it the file at
    [path]: it lies beside [path], is flushed to the disk and then renamed. If
    anything fails the result is a message that names [path] and the reason,
    and what was at [path] before is untouched, unless it had to be copied
    over. Symbolic links are followed. Of a file that was there the mode is
    kept, and the owner where the system lets one.

    What is no regular file, such as a pipe or a device, and what the process
    has open, such as [/dev/stdout], is written through: what is there stays,
    and the bytes come after it.

    [write] fails by raising [Sys_error], as a channel does. What else it
    raises is raised again, after the same cleaning. *)

val check : path:string -> bytes:int -> (unit, string) result
(** [check ~path ~bytes] is the message with which a {!save} of at least
    [bytes] to [path] would fail now, if that can be known: to say so before
    there is much work for nothing. It makes a temporary file of that size, and
    removes it. *)

val wrote : path:string -> outcome -> string
(** [wrote ~path outcome] says that [path] was written, and what it cost if it
    had to be copied over. *)

(** {1 Standard output} *)

val output : out_channel -> (out_channel -> unit) -> (unit, string) result
(** [output channel write] lets [write] write to [channel], in binary mode, and
    flushes that. If this fails the result is a message that names standard
    output, and [channel] is closed, so that it cannot fail again when the
    program ends. Nothing is needed but [channel]. *)

val print : string -> (unit, string) result
(** [print text] is {!output} of [text] to standard output. *)

val check_output : unit -> (unit, string) result
(** [check_output ()] is the message with which {!output} to standard output
    would fail now, if that can be known: it is closed. *)

(** {1 Ending} *)

val temporary : unit -> string list
(** [temporary ()] is the files that a {!save} or {!check} under way would
    leave behind if the program ended now: what a signal handler has to remove.
*)
