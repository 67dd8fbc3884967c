(** Where a window shows a picture, and which pixel is where.

    The picture is as large as the window allows, in the middle: with each
    pixel as a square of 1, 2, 3 ... pixels of the window, or else scaled down
    to fit, with its proportions. *)

type t
(** The type for layouts. *)

val window_size : screen:(int * int) option -> int * int -> int * int
(** [window_size ~screen picture] is how large a window for a picture of this
    width and height should be: as large, but if the screen is smaller scaled
    down to leave some of the screen free. *)

val make : window:int * int -> picture:int * int -> t
(** [make ~window ~picture] is the layout for these widths and heights, each at
    least 1. *)

val window : t -> Box.t
(** [window layout] is all of the window. *)

val shown : t -> Box.t
(** [shown layout] is the part of the window that shows the picture. *)

val pixel : t -> int * int -> (int * int) option
(** [pixel layout place] is the pixel of the picture that is shown at a place
    of the window, or [None] beside the picture. Where one place shows several
    pixels it is one in their middle. *)

val place : t -> float * float -> float * float
(** [place layout p] is where the window shows the point [p] of the picture,
    both in pixels from the left and the top. *)

val box : t -> Box.t -> Box.t
(** [box layout b] is the part of the window that shows [b], a part of the
    picture; also where it shows but part of a pixel. *)

val columns : t -> int -> int * int
(** [columns layout x] is the first and the last column of the picture that
    column [x] of {!shown}, from 0, shows. *)

val rows : t -> int -> int * int
(** [rows layout y] is likewise for rows. *)
