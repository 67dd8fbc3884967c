(** The folder of a job. *)

val write :
  string -> files:(string * string) list -> Job.t -> (unit, string) result
(** [write path ~files job] makes the folder at [path] that {!Job} tells of,
    with [files], names relative to the folder and texts, of which the scene is
    {!Job.scene}. What is there already is left alone if it is the same, so
    that bands stay there; if a file is another, nothing is written. The result
    is a message if that is so, or if something cannot be written. *)

val submit : string -> string
(** [submit path] is the path of the script that submits the job in the folder
    at [path]. *)
