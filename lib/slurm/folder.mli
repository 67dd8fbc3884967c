(** The folder of a job. *)

val write : string -> scene:string -> Job.t -> (unit, string) result
(** [write path ~scene job] makes the folder at [path] that {!Job} tells of,
    with [scene] as the text of the scene. What is there already is left alone
    if it is the same, so that bands stay there; if a file is another, nothing
    is written. The result is a message if that is so, or if something cannot
    be written. *)

val submit : string -> string
(** [submit path] is the path of the script that submits the job in the folder
    at [path]. *)
