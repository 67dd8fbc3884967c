(** Files of the formats that hold rows one after another, BMP and PPM, piece
    by piece.

    The library that writes the other picture files takes whole pictures only.
    What is made here is, byte for byte, what it makes, and a label: a text
    that viewers do not show. *)

type t =
  | Bmp  (** the lowest row first; the label lies before the pixels *)
  | Ppm  (** the topmost row first; the label is a comment *)

val header : t -> label:string -> width:int -> height:int -> string
(** [header format ~label ~width ~height] is everything before the rows. An
    empty [label] is none. The label of a PPM is one line. *)

val label : t -> string -> string option
(** [label format start] is the label of a file that starts with [start], if
    there is one that ends in [start]. *)

val stride : t -> width:int -> int
(** [stride format ~width] is the number of bytes of a row. *)

val lowest_first : t -> bool
(** [lowest_first format] is whether files start with the lowest row. *)

val encode : t -> width:int -> bytes -> bytes
(** [encode format ~width rgb] is what a file has for rows that follow each
    other: [rgb], red, green and blue bytes from the topmost row. It may be
    [rgb] itself. *)

val decode : t -> width:int -> bytes -> bytes
(** [decode format ~width bytes] is the [rgb] of which [bytes] are {!encode},
    or [bytes] itself. *)

val write :
  t ->
  label:string ->
  width:int ->
  height:int ->
  (lowest_first:bool -> (bytes -> unit) -> unit) ->
  string ->
  unit
(** [write format ~label ~width ~height iter path] fills the file at [path].
    [iter ~lowest_first emit] calls [emit] with the rows, piece by piece, from
    the lowest or from the topmost piece on. Fails as
    {!Raylab_picture.Atomic_file.save} wants it. *)
