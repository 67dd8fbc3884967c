type t = float * float

let between (x, y) (x', y') =
  let dx = x' -. x and dy = y' -. y in
  let length = Float.hypot dx dy in
  (length, (dx /. length, dy /. length))

let from (x, y) (ux, uy) along aside =
  (x +. (along *. ux) -. (aside *. uy), y +. (along *. uy) +. (aside *. ux))
