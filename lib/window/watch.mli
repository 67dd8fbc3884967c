(** Watching files for changes.

    A change is told by what the system knows of a file, so that it does not
    matter whether an editor writes into the file or puts another in its place.
*)

type t
(** The type for watches. *)

val start : string -> t
(** [start path] watches the file at [path] from now on. *)

val has_changed : t -> bool
(** [has_changed watch] is whether a file was changed, since the last question
    or the start, and has settled since; see {!Raylab_viewer.Changes}. *)

val follow : t -> string list -> unit
(** [follow watch paths] also watches the files at [paths], from now on,
    instead of those that it was told to follow before. What it watches already
    it goes on watching. Another domain than that of {!has_changed} may call
    it. *)
