(** Paths of what a process holds open, such as [/dev/stdout] or [/dev/fd/3].
*)

type t =
  | Own of int  (** this process has it open under this number *)
  | Foreign  (** another process has it open *)

val of_path : string -> t option
(** [of_path path] is the descriptor that [path] itself stands for, links in
    the folders before its last part followed, if there is a folder of
    descriptors. Whether it is open is another question. *)

val is_writable : int -> bool
(** [is_writable n] is whether descriptor [n] is open for writing, as far as
    the system tells. *)

val duplicate : int -> Unix.file_descr
(** [duplicate n] is another descriptor of what [n] is of, at the same place in
    it. Fails with [Unix.Unix_error] if [n] is not open. *)
