(** Pictures and folders for these tests. *)

open Raylab_tracer

val picture : width:int -> height:int -> Picture.t
(** [picture ~width ~height] has another colour in every pixel, as far as there
    are colours. *)

val in_new_folder : (string -> unit) -> unit -> unit
(** [in_new_folder f ()] is [f folder] for an empty folder, which is removed
    afterwards with all files in it. *)

val files : string -> string list
(** [files folder] is the names of all files in [folder], sorted. *)

val read : string -> string
(** [read path] is the bytes of a file. *)

val write : string -> string -> unit
(** [write path text] makes [text] the bytes of a file. *)

val formats : Raylab_picture.Picture_file.format list
(** [formats] is all of them. *)
