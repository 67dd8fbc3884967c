(** The window itself: a thin layer over Graphics.

    This is the only module that uses Graphics, and only the main domain may
    use it. Places are in pixels from the left and from the {e top}; colours
    are [0xRRGGBB]. What is drawn is seen after {!show}. *)

open Raylab_drawing
open Raylab_viewer

type t
(** The type for windows. There is one at a time. *)

exception Gone
(** The window, or the whole display, went away: every function but {!close}
    may raise this. Only {!close} may be called afterwards. *)

val open_ :
  on_loss:(unit -> unit) ->
  title:string ->
  width:int ->
  height:int ->
  (t, string) result
(** [open_ ~on_loss ~title ~width ~height] opens a window, or says in a line
    why it cannot. After one window was {!Gone} no other can be opened.
    [on_loss] is called before {!Gone} is raised for the first time. *)

val close : t -> unit
(** [close canvas] closes the window, if it is not gone. *)

(** {1 The window} *)

val size : t -> int * int
(** [size canvas] is its width and height now. *)

val resize : t -> width:int -> height:int -> unit
(** [resize canvas ~width ~height] asks for another size. *)

val set_title : t -> string -> unit
(** [set_title canvas title] makes its frame show [title]. *)

(** {1 Drawing} *)

val paint : t -> left:int -> top:int -> int array array -> unit
(** [paint canvas ~left ~top colors] shows [colors], row by row from the top.
    Without any it does nothing. *)

val line : t -> color:int -> width:int -> Drawing.point * Drawing.point -> unit
(** [line canvas ~color ~width (a, b)] draws a line [width] pixels thick. *)

val disc : t -> color:int -> radius:int -> Drawing.point -> unit
(** [disc canvas ~color ~radius centre] draws a filled circle. *)

val polygon : t -> color:int -> Drawing.point list -> unit
(** [polygon canvas ~color corners] draws a filled polygon. *)

val fill : t -> color:int -> Box.t -> unit
(** [fill canvas ~color box] fills [box]. *)

val text : t -> color:int -> left:int -> top:int -> string -> unit
(** [text canvas ~color ~left ~top line] writes a line of ASCII. *)

val text_size : t -> string -> int * int
(** [text_size canvas line] is its width and height. *)

val show : t -> unit
(** [show canvas] makes everything drawn so far seen. *)

(** {1 Events} *)

(** The type for what a user does: a key, and a button of the mouse that goes
    down or up at a place. *)
type event = Key of char | Down of int * int | Up of int * int

val next : t -> seconds:float -> event option
(** [next canvas ~seconds] is the next event, as soon as there is one; [None]
    if there is none for [seconds]. The wheel of a mouse is a button, too. *)

val pointer : t -> int * int
(** [pointer canvas] is where the pointer is now. *)
