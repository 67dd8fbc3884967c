(** Where a picture goes: to a file, or to standard output. *)

open Raylab_picture
open Raylab_band
open Raylab_tracer

type t = Standard_output | File of string  (** The type for destinations. *)

val of_path : string -> t
(** [of_path path] is the file at [path]; standard output if it is ["-"]. *)

val check : Picture_file.format -> t -> width:int -> height:int -> unit
(** [check format destination ~width ~height] ends the program if a picture of
    this size cannot be written there, as far as that is known before: what is
    known to fail must not fail after hours of rendering. *)

val write :
  quiet:bool -> Picture_file.format -> t -> Band.t option -> Picture.t -> unit
(** [write ~quiet format destination band picture] writes [picture], which is
    [band] of a larger one if that is given, and says where, unless [quiet]. It
    ends the program if that fails. *)
