(** Bands become the whole picture.

    Memory is needed for a piece of a band, and for a band that is a PNG. *)

open Raylab_picture

type t
(** The type for bands that make a picture: all files are whole, they belong
    together, no row is missing, and where they overlap they agree. *)

val files : string list -> (string list, string list) result
(** [files paths] is [paths] with the files that are in it instead of each
    folder, but for those whose names start with a dot, or messages that say
    which folder cannot be read. *)

val check : string list -> (t, string list) result
(** [check paths] is the picture that the bands in the files [paths] make,
    whatever their order, or messages that name the files, or the rows, that
    keep it from being one. Every file is read. *)

val whole : t -> Band.whole
(** [whole join] is which picture it is. *)

type failure =
  | Unreadable of string  (** a band has changed since it was checked *)
  | Unwritable of string
      (** the message of {!Raylab_picture.Atomic_file.save} *)

val save :
  t ->
  Picture_file.format ->
  path:string ->
  (Atomic_file.outcome, failure) result
(** [save join format ~path] writes the picture to [path]. It is the file that
    {!Raylab_picture.Picture_file.save} makes of the picture rendered at once,
    byte for byte. *)

val output : t -> Picture_file.format -> out_channel -> (unit, failure) result
(** [output join format channel] writes it to [channel]; see
    {!Raylab_picture.Picture_file.output}. *)
