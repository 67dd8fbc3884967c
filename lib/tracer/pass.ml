type t = { step : int; first : bool; is_smooth : bool }

let whole = { step = 1; first = true; is_smooth = false }
let smooth = { whole with is_smooth = true }
let is_smooth pass = pass.is_smooth
let step pass = pass.step

(* [every step length] is how many of 0, step, 2 step ... are below [length] *)
let every step length = (length + step - 1) / step

(* 640 x 480 pixels, every 8th of every 8th row, are 4,800 *)
let most_at_first = 5000
let least_step_at_first = 8

let coarse ~last ~width ~height =
  let rec first step =
    if every step width <= most_at_first / every step height then step
    else first (2 * step)
  in
  let rec finer step =
    if step < last then []
    else { whole with step; first = false } :: finer (step / 2)
  in
  let step = first least_step_at_first in
  Array.of_list ({ whole with step } :: finer (step / 2))

let coarse_to_fine = coarse ~last:1
let coarse_to_smooth = coarse ~last:2

(* {1 Tiles} *)

let side { step; is_smooth; _ } =
  if is_smooth then Centres.largest_side else Int.max Tile.side (2 * step)

let count pass = Tile.count ~side:(side pass)
let nth pass = Tile.nth ~side:(side pass)

let pixels { step; first; _ } { Tile.width; height; _ } =
  let known step = every step width * every step height in
  known step - if first then 0 else known (2 * step)

let iter { step; first; _ } { Tile.left; top; width; height } f =
  (* tiles start at multiples of this step and of the one before *)
  let is_known x y = (not first) && x lor y land ((2 * step) - 1) = 0 in
  for j = 0 to every step height - 1 do
    let y = top + (j * step) in
    for i = 0 to every step width - 1 do
      let x = left + (i * step) in
      if not (is_known x y) then f ~x ~y
    done
  done
