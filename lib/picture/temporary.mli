(** Temporary files, none of which is left behind. *)

type t = { path : string; channel : out_channel }
(** The type for temporary files that are being written. *)

val file : t -> Unix.file_descr
(** [file part] is what [part.channel] writes to. It can be read, too. *)

val in_use : unit -> string list
(** [in_use ()] is the paths that would be left behind if the program ended
    now. *)

val make : string -> string -> t
(** [make folder extension] is a new, empty file in [folder], which nobody else
    can read or write, with a name of its own that ends with [extension]. Fails
    with [Unix.Unix_error]. *)

val use : t -> (t -> 'a) -> 'a
(** [use part f] is [f part], after which [part] is closed, and removed if it
    is still there. *)
