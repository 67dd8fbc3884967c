(** Bands: rows of a picture that know where they belong. *)

open Raylab_scene
open Raylab_picture

type whole = {
  width : int;  (** in pixels *)
  height : int;  (** in pixels *)
  grey : bool;  (** rendered in greyscale *)
  film : Film.t;  (** as it was rendered, whatever the scene says *)
  scene : Digest.t;  (** of the text of the scene, without byte-order mark *)
  version : string;  (** of the raylab that rendered it *)
}
(** The whole picture of which a band is part. Bands with equal wholes belong
    together. *)

type t = private { whole : whole; first : int; last : int }
(** The type for bands: rows [first] to [last], both included, counted from 0
    at the top. *)

val make : whole -> first:int -> last:int -> t
(** [make whole ~first ~last] is that band of [whole].

    Raises [Invalid_argument] if there are no such rows, width or height are
    not between 1 and {!Raylab_scene.Camera.max_size}, or [version] is not of
    one to 32 letters, digits, points, dashes, pluses and tildes. *)

val rows : t -> int
(** [rows band] is how many rows it has. *)

val difference : whole -> whole -> string option
(** [difference a b] says why bands of [a] and [b] do not belong together, such
    as ["the sizes differ, 60x40 and 30x20"], or is [None] if they do. *)

(** {1 Labels}

    A label is a line of ASCII that travels in the file of a band, such as
    this, which is broken here:

    {v
    raylab-band 2 rows 10-19 of 60x40 rgb samples 16 exposure 1 linear
    scene 0cc175b9c0f1b6a831c399e269772661 raylab 0.1.0 crc32 e8b7be43
    v}

    [2] is the version of labels, [rgb] may be [grey], [linear] may be [srgb],
    and the checksum at the end is of the label up to [raylab 0.1.0] and of the
    pixels, row by row from the top, as red, green and blue bytes. *)

val checksum : t -> Crc32.t
(** [checksum band] is the checksum of the label without the pixels, which are
    to be added. *)

val label : t -> Crc32.t -> string
(** [label band crc] is the label of [band], whose checksum is [crc]. It has at
    most 250 characters. *)

val with_checksum : t -> string -> string
(** [with_checksum band digits] is {!label} of a checksum's digits. *)

val of_label : string -> (t * string) option
(** [of_label text] is the band whose label [text] is, and the hexadecimal
    digits of the checksum, or [None] if it is no label. *)
