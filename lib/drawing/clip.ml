let narrow (first, last) ~from ~step low high =
  if step = 0. then
    if low <= from && from <= high then (first, last)
    else (infinity, neg_infinity)
  else
    let a = (low -. from) /. step and b = (high -. from) /. step in
    (Float.max first (Float.min a b), Float.min last (Float.max a b))

let segment { Rectangle.left; top; right; bottom } ((x, y), (x', y')) =
  let dx = x' -. x and dy = y' -. y in
  let range = narrow (0., 1.) ~from:x ~step:dx left right in
  let first, last = narrow range ~from:y ~step:dy top bottom in
  let at t = (x +. (t *. dx), y +. (t *. dy)) in
  if first <= last then Some (at first, at last) else None
