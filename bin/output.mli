(** Picture files that the command line names. *)

open Raylab_picture

val beside : string -> string
(** [beside scene] is where the picture of the scene file [scene] goes if
    nothing else is said: its name with [.bmp]. *)

val format :
  string -> inputs:string list -> named:string -> Picture_file.format
(** [format path ~inputs ~named] is the format that [path] names. The program
    ends with a usage error if there is no such format, if [path] is empty, or
    if it is one of the files [inputs], which messages call [named]. *)

val remove_temporary_files : unit -> unit
(** [remove_temporary_files ()] removes what a file that is being written would
    leave behind if the program ended now. *)
