(** Copies of the files of a scene, for the folder of a job. *)

open Raylab_source

val make : Sources.t -> (Span.t * Sources.file) list -> (string * string) list
(** [make sources inclusions] is names in the folder and texts of all
    [sources], the scene first, as {!Job.scene}. [inclusions] is where files
    are named, with the quotes, and which ones. A file keeps its name relative
    to the scene if it can have it in the folder; else it is in [included], and
    the copies say so where they include it. *)
