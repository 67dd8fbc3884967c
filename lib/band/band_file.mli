(** Files of bands, which {!Band_writer} has written: reading them. *)

open Raylab_picture

type t
(** The type for files of bands that were found whole. *)

val check : string -> (t, string) result
(** [check path] is the band in the file at [path], all of which is read, or a
    message that names [path] and says that it is no band, or damaged: that it
    has not, byte for byte, the headers, length and checksum that
    {!Band_writer.save} would have given it. Whatever the bytes, it raises
    nothing, unless memory runs out. *)

val path : t -> string
(** [path file] is where it is. *)

val band : t -> Band.t
(** [band file] is the band in it. *)

val with_rows : t -> (Rows.t -> 'a) -> 'a
(** [with_rows file f] is [f rows] for the rows of the band. A BMP or PPM is
    read as [rows] is called, a PNG at once.

    Raises {!Unreadable} if the file is not any more what it was when it was
    checked. *)

exception Unreadable of string
(** Of a message that names the path. *)
