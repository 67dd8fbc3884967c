open Raylab_drawing

type t = { left : int; top : int; width : int; height : int }

let empty = { left = 0; top = 0; width = 0; height = 0 }
let is_empty { width; height; _ } = width <= 0 || height <= 0

let contains { left; top; width; height } (x, y) =
  left <= x && x < left + width && top <= y && y < top + height

let of_sides ~left ~top ~right ~bottom =
  { left; top; width = right - left; height = bottom - top }

let right box = box.left + box.width
let bottom box = box.top + box.height

let rectangle box =
  {
    Rectangle.left = float_of_int box.left;
    top = float_of_int box.top;
    right = float_of_int (right box);
    bottom = float_of_int (bottom box);
  }

let inter a b =
  of_sides ~left:(Int.max a.left b.left) ~top:(Int.max a.top b.top)
    ~right:(Int.min (right a) (right b))
    ~bottom:(Int.min (bottom a) (bottom b))

let union a b =
  if is_empty a then b
  else if is_empty b then a
  else
    of_sides ~left:(Int.min a.left b.left) ~top:(Int.min a.top b.top)
      ~right:(Int.max (right a) (right b))
      ~bottom:(Int.max (bottom a) (bottom b))
