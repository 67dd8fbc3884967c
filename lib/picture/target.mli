(** What a path leads to: what is to be done there to write, and whether it can
    be read twice. *)

type t =
  | File of string * Unix.stats
      (** a regular file, by its path after all links *)
  | Nothing of string  (** no file yet; here one would be *)
  | Descriptor of int  (** what this process has open under this number *)
  | Stream of string
      (** anything else that takes and gives bytes: a pipe, a device, what
          another process has open *)

val of_path : string -> t
(** [of_path path] is what [path] leads to. Fails with [Unix.Unix_error] if it
    leads nowhere, to a folder or to a socket. Nothing is opened. *)

val has_name : string -> bool
(** [has_name path] is whether a file at [path] would be called so: others can
    be called after it, and it can be read again. What is open or no regular
    file has none. *)

val is_standard_input : string -> bool
(** [is_standard_input path] is whether [path] is ["-"] or leads to what this
    process has open as its standard input, as [/dev/stdin] does. *)

val is_standard_output : string -> bool
(** [is_standard_output path] is likewise of standard output. *)
