(** What is wrong with a scene, or hardly meant in it, for programs that show
    it in the text. *)

open Raylab_source

type severity = Error | Warning

type t = {
  severity : severity;
  file : string;  (** {!Raylab_source.Printable} *)
  place : Sources.place option;  (** [None]: the file as a whole *)
  message : string;  (** in one line *)
  remedy : string;  (** what to do, or [""] *)
}
(** The type for problems. *)

val of_reading : string -> Scene_file.reading -> t list
(** [of_reading path reading] is all that is wrong with the scene at [path],
    or, if nothing is, all that is hardly meant in it. *)
