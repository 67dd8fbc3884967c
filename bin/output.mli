(** Picture files that the command line names. *)

open Raylab_picture

val beside : string -> string
(** [beside scene] is where the picture of the scene file [scene] goes if
    nothing else is said: its name with [.bmp]. *)

val format : scene:string -> string -> Picture_file.format
(** [format ~scene path] is the format that [path] names. The program ends with
    a usage error if there is no such format, if [path] is empty, or if it is
    the file [scene]. *)
