(** What the pixels of a window show. *)

type look = {
  color : x:int -> y:int -> int;
      (** the colour of a pixel of the picture, as [0xRRGGBB] *)
  step : x:int -> y:int -> int;
      (** the side, a power of two, of the block around it that has this
          colour, whose corners have multiples of it as coordinates: 1 if that
          is only the pixel itself, 0 if nothing is known there *)
}
(** The type for what a picture looks like, as far as it is known. *)

val dim : look -> look
(** [dim look] is a darker [look], before which white text can be read. *)

(** {1 The window} *)

type t
(** The type for what all pixels of a window show. *)

val make : Layout.t -> background:int -> t
(** [make layout ~background] is a window that is laid out so, where
    [background] is beside the picture. *)

val rows : t -> look -> top:int -> height:int -> int array array
(** [rows raster look ~top ~height] is the colours of [height] rows of the
    window, from row [top] on, where the picture has this [look].

    A pixel of the window that shows several of the picture has their mean, or
    that of 16 of them, evenly spread, if it shows more. Where the picture is
    still in blocks it has the colour of a single one, so that a coarse picture
    is drawn at once.

    The same arrays are filled again by the next call for [raster], since new
    ones would be collected, for which all domains that render would be
    stopped. *)
