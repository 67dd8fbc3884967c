(** Writing bands: ordinary pictures of a band's rows, with its {!Band.label}
    in a place where viewers do not mind it.

    - In a PPM it is the first comment.
    - In a BMP it is the line after the pixels.
    - In a PNG it is a chunk tEXt with the keyword Comment. *)

open Raylab_tracer
open Raylab_picture

val save :
  Picture_file.format ->
  path:string ->
  Band.t ->
  Picture.t ->
  (Atomic_file.outcome, string) result
(** [save format ~path band rows] writes the picture [rows] of [band] to
    [path]; see {!Raylab_picture.Picture_file.save}.

    Raises [Invalid_argument] if [rows] has another size than [band]. *)

val output :
  Picture_file.format ->
  out_channel ->
  Band.t ->
  Picture.t ->
  (unit, string) result
(** [output format channel band rows] writes likewise to [channel]; see
    {!Raylab_picture.Picture_file.output}. *)
