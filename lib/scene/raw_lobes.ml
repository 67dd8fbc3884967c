open Raylab_geometry.Unchecked

let emission = 0
let albedo = 3
let mirror = 6
let size = 9
let create ~rows = Array.make (size * rows) 0.

let[@inline] set numbers at ({ r; g; b } : Color.t) =
  numbers.(at) <- r;
  numbers.(at + 1) <- g;
  numbers.(at + 2) <- b

let clear numbers at = Array.fill numbers at size 0.

let add_next numbers at weight =
  for k = at to at + size - 1 do
    numbers.(k) <-
      Saturate.limit (numbers.%(k) +. (weight *. numbers.(k + size)))
  done

let read numbers at =
  let color k = Color.make numbers.(k) numbers.(k + 1) numbers.(k + 2) in
  {
    Lobes.emission = color (at + emission);
    albedo = color (at + albedo);
    mirror = color (at + mirror);
  }
