(** Copies of the files of a scene, for the folder of a job. *)

open Raylab_source

val make : Sources.t -> (Span.t * string) list -> (string * string) list
(** [make sources named] is names in the folder and bytes of all files of
    [sources], the scene first, as {!Job.scene}. [named] is where files are
    named, with the quotes, and the paths of these. A file keeps its name
    relative to the scene if it can have it in the folder; else it is in
    [included], and the copies say so where they name it. *)
