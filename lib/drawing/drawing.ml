open Raylab_scene

type point = float * float
type ink = int
type stroke = { ink : ink; width : float; dashes : (float * float) option }
type color = Ink of ink | Seen of Color.t
type look = { fill : color; opacity : float; outline : stroke option }
type anchor = Start | Middle | End
type level = Base | Top

type text = {
  words : string;
  place : point;
  anchor : anchor;
  level : level;
  size : float;
  ink : ink;
}

type mark =
  | Line of stroke * point * point
  | Circle of look * point * float
  | Polygon of look * point list
  | Box of look * Rectangle.t
  | Text of text

type t = mark list

let ascent = 0.8
let stroke ?dashes ~width ink = { ink; width; dashes }
let filled ?(opacity = 1.) ?outline color = { fill = color; opacity; outline }

let text ?(anchor = Start) ?(level = Base) ?(size = 12.) ?(ink = 0x222222)
    place words =
  Text { words; place; anchor; level; size; ink }
