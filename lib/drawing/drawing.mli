(** Drawings: lines, areas and words as data, for whoever renders them.

    {!Svg} renders them as text, and a window or a page as it can: nothing else
    needs to be known for that than what is here. *)

open Raylab_scene

type point = float * float
(** The type for places, in pixels from the left and from the top. They may be
    far outside of what is shown. *)

type ink = int
(** The type for colours of the drawing's own, as [0xRRGGBB]. *)

type stroke = {
  ink : ink;
  width : float;  (** in pixels, as all lengths are *)
  dashes : (float * float) option;
      (** the lengths of a dash and of the gap after it; none has no gaps *)
}
(** The type for pens. *)

(** The type for colours of areas. *)
type color =
  | Ink of ink
  | Seen of Color.t  (** a colour of the scene, as a picture shows it *)

type look = {
  fill : color;
  opacity : float;  (** of the fill, from 0 to 1 *)
  outline : stroke option;
}
(** The type for looks of areas. *)

(** The type for where in words their place is, across. *)
type anchor = Start | Middle | End

(** The type for where in words their place is, from top to bottom. *)
type level =
  | Base  (** the line on which the letters stand *)
  | Top  (** that of the highest letter *)

type text = {
  words : string;
  place : point;
  anchor : anchor;
  level : level;
  size : float;  (** of the letters, if the renderer has several *)
  ink : ink;
}
(** The type for words: any string, on one line. *)

(** The type for the parts of a drawing. *)
type mark =
  | Line of stroke * point * point
  | Circle of look * point * float  (** by its centre and its radius *)
  | Polygon of look * point list  (** by its corners *)
  | Box of look * Rectangle.t
  | Text of text

type t = mark list
(** The type for drawings: the first mark is farthest back. *)

val ascent : float
(** [ascent] is how far {!Top} is above {!Base}, as a part of the size. *)

(** {1 Short forms} *)

val stroke : ?dashes:float * float -> width:float -> ink -> stroke
(** [stroke ~dashes ~width ink] is a pen, by default without gaps. *)

val filled : ?opacity:float -> ?outline:stroke -> color -> look
(** [filled ~opacity ~outline color] is the look of an area, by default opaque
    and without an outline. *)

val text :
  ?anchor:anchor ->
  ?level:level ->
  ?size:float ->
  ?ink:ink ->
  point ->
  string ->
  mark
(** [text ~anchor ~level ~size ~ink place words] is [words] at [place]: unless
    it is said, they start there, on the base line, 12 pixels high and nearly
    black. *)
