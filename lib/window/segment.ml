type point = float * float
type t = point * point

(* Narrows the parameters (s, e) of a line to those for which the coordinate
   [from + t * step] lies between [low] and [high] (Liang and Barsky, 1984). *)
let narrow (s, e) from step low high =
  if step = 0. then
    if low <= from && from <= high then (s, e) else (infinity, neg_infinity)
  else
    let a = (low -. from) /. step and b = (high -. from) /. step in
    (Float.max s (Float.min a b), Float.min e (Float.max a b))

let at ((x, y), (x', y')) t = (x +. (t *. (x' -. x)), y +. (t *. (y' -. y)))

let clip (box : Box.t) (((x, y), (x', y')) as line) =
  let within start length =
    (float_of_int start, float_of_int (start + length))
  in
  let left, right = within box.left box.width
  and top, bottom = within box.top box.height in
  let range = narrow (0., 1.) x (x' -. x) left right in
  let s, e = narrow range y (y' -. y) top bottom in
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
