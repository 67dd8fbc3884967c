type t = { step : int; first : bool }

let whole = { step = 1; first = true }

let coarse_to_fine =
  [|
    { step = 8; first = true };
    { step = 4; first = false };
    { step = 2; first = false };
    { step = 1; first = false };
  |]

let step pass = pass.step

(* [every step length] is how many of 0, step, 2 step ... are below [length] *)
let every step length = (length + step - 1) / step

let pixels { step; first } { Tile.width; height; _ } =
  let known step = every step width * every step height in
  known step - if first then 0 else known (2 * step)

let iter { step; first } { Tile.left; top; width; height } f =
  (* tiles start at multiples of every step *)
  let is_known x y = (not first) && x lor y land ((2 * step) - 1) = 0 in
  for j = 0 to every step height - 1 do
    let y = top + (j * step) in
    for i = 0 to every step width - 1 do
      let x = left + (i * step) in
      if not (is_known x y) then f ~x ~y
    done
  done
