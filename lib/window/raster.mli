(** What the pixels of a window show. *)

val colors :
  Layout.t ->
  (x:int -> y:int -> int) ->
  background:int ->
  Box.t ->
  int array array
(** [colors layout color ~background box] is the colours, as [0xRRGGBB], of the
    part [box] of the window, row by row from the top, where [color ~x ~y] is
    the colour of a pixel of the picture and [background] is what is beside it.

    A pixel of the window that shows several of the picture has their mean, or
    that of 16 of them, evenly spread, if it shows more. *)

val dim : int -> int
(** [dim color] is a darker [color], before which white text can be read. *)
