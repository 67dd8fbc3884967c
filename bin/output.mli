(** Picture files that the command line names. *)

open Raylab_picture

val beside : ?format:Picture_file.format -> string -> string
(** [beside ~format scene] is where the picture of the scene file [scene] goes
    if nothing else is said: its name, without [.scene] or [.txt], with the
    extension of [format], by default [.bmp]. *)

val format :
  ?wanted:Picture_file.format ->
  string ->
  inputs:string list ->
  named:string ->
  Picture_file.format
(** [format ~wanted path ~inputs ~named] is the format that [path] names, or if
    it has no extension [wanted], by default BMP. The program ends with a usage
    error if there is no such format or it is not [wanted], if [path] is empty,
    or if it is one of the files [inputs], which messages call [named]. *)

val protect : string -> Raylab_language.Scene_file.reading -> unit
(** [protect path reading] ends the program with a usage error if the file at
    [path] is one of those that were read for the scene. *)

val wanted : Picture_file.format option Cmdliner.Term.t
(** [wanted] is the option [--format]. *)

val remove_temporary_files : unit -> unit
(** [remove_temporary_files ()] removes what a file that is being written would
    leave behind if the program ended now. *)
