open Raylab_drawing

type point = float * float
type t = point * point

let at ((x, y), (x', y')) t = (x +. (t *. (x' -. x)), y +. (t *. (y' -. y)))

let clip (box : Box.t) (((x, y), (x', y')) as line) =
  let within start length =
    (float_of_int start, float_of_int (start + length))
  in
  let left, right = within box.left box.width
  and top, bottom = within box.top box.height in
  let range = Clip.narrow (0., 1.) ~from:x ~step:(x' -. x) left right in
  let s, e = Clip.narrow range ~from:y ~step:(y' -. y) top bottom in
  if s <= e then Some (at line s, at line e) else None

let dash = 6.
let gap = 4.

let dashes (((x, y), (x', y')) as line) =
  let length = Float.hypot (x' -. x) (y' -. y) in
  let period = dash +. gap in
  List.init
    (int_of_float (Float.ceil (length /. period)))
    (fun k ->
      let start = float_of_int k *. period in
      ( at line (start /. length),
        at line (Float.min 1. ((start +. dash) /. length)) ))
