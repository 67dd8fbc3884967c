(** Watching a file for changes.

    A change is told by what the system knows of the file, so that it does not
    matter whether an editor writes into the file or puts another in its place.
*)

type t
(** The type for watches. *)

val start : string -> t
(** [start path] watches the file at [path] from now on. *)

val has_changed : t -> bool
(** [has_changed watch] is whether the file was changed since the last
    question, or since the start; see {!Raylab_viewer.Changes}. *)
