type t = { left : float; top : float; right : float; bottom : float }

let around (x, y) r =
  { left = x -. r; top = y -. r; right = x +. r; bottom = y +. r }

let contains { left; top; right; bottom } (x, y) =
  left <= x && x <= right && top <= y && y <= bottom

let overlap a b =
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom

let holds a b =
  a.left <= b.left && b.right <= a.right && a.top <= b.top
  && b.bottom <= a.bottom

let way_into a b =
  let way low high low' high' =
    Float.max (low -. low') (Float.min 0. (high -. high'))
  in
  (way a.left a.right b.left b.right, way a.top a.bottom b.top b.bottom)
