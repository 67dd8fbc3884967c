(** Picture files. *)

open Raylab_tracer

type format = Bmp | Png | Ppm

val formats : (string * format) list
(** [formats] is the file name extensions, in lower case, with the format that
    each stands for. *)

val extension : format -> string
(** [extension format] is the one of its files, such as [".png"]. *)

val format_of_path : ?default:format -> string -> (format, string) result
(** [format_of_path path] is the format that the extension of [path] names,
    whatever its case, or [default], {!Bmp} if not given, if there is none; or
    a message that says which extensions there are. *)

val check_size : format -> width:int -> height:int -> (unit, string) result
(** [check_size format ~width ~height] is whether a picture of this size fits
    into memory as far as raylab goes, 4 GiB, and into [format], or a message
    that says why not. *)

val check_format : format -> width:int -> height:int -> (unit, string) result
(** [check_format format ~width ~height] is {!check_size} without the limit of
    memory: for a picture that is not in memory as a whole. *)

val check :
  format -> path:string -> width:int -> height:int -> (unit, string) result
(** [check format ~path ~width ~height] is the message with which a {!save} of
    such a picture would fail now, if that can be known; see
    {!Atomic_file.check}. How large a PNG becomes is not known before. *)

val save :
  format -> path:string -> Picture.t -> (Atomic_file.outcome, string) result
(** [save format ~path picture] writes [picture] to [path], so that the file
    appears whole or not at all; see {!Atomic_file.save}. *)

val output : format -> out_channel -> Picture.t -> (unit, string) result
(** [output format channel picture] writes [picture] to [channel], in binary
    mode, and flushes it. *)

(** {1 Piece by piece} *)

val save_pixels :
  format -> path:string -> Pixels.t -> (Atomic_file.outcome, string) result
(** [save_pixels] is {!save} of pixels as they come. What [pixels.iter] raises
    it raises, and nothing is written. *)

val output_pixels : format -> out_channel -> Pixels.t -> (unit, string) result
(** [output_pixels] is {!output} likewise. *)
