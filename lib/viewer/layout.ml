type t = { window : Box.t; shown : Box.t; width : int; height : int }

(* [scaled (w, h) (a, b)] is the largest size of proportions [w] to [h] that
   fits into [a] x [b]. *)
let scaled (w, h) (a, b) =
  if a * h <= b * w then (a, Int.max 1 (a * h / w))
  else (Int.max 1 (b * w / h), b)

let window_size ~screen ((w, h) as picture) =
  match screen with
  | Some (a, b) when w > a || h > b -> scaled picture (a * 9 / 10, b * 9 / 10)
  | _ -> picture

let make ~window:((a, b) as window) ~picture:((w, h) as picture) =
  let factor = Int.min (a / w) (b / h) in
  let width, height =
    if factor >= 1 then (factor * w, factor * h) else scaled picture window
  in
  {
    window = { left = 0; top = 0; width = a; height = b };
    shown = { left = (a - width) / 2; top = (b - height) / 2; width; height };
    width = w;
    height = h;
  }

let window layout = layout.window
let shown layout = layout.shown

let pixel { shown; width; height; _ } ((u, v) as place) =
  if not (Box.contains shown place) then None
  else
    let middle offset length shown =
      ((2 * offset) + 1) * length / (2 * shown)
    in
    Some
      ( middle (u - shown.left) width shown.width,
        middle (v - shown.top) height shown.height )

let place { shown; width; height; _ } (x, y) =
  let at start length shown offset =
    float_of_int start +. (offset *. float_of_int shown /. float_of_int length)
  in
  (at shown.left width shown.width x, at shown.top height shown.height y)

let ceil_div a b = (a + b - 1) / b

let box { shown; width; height; _ } (b : Box.t) =
  let along start length shown first count =
    let low = first * shown / length
    and high = ceil_div ((first + count) * shown) length in
    (start + low, high - low)
  in
  let left, w = along shown.left width shown.width b.left b.width
  and top, h = along shown.top height shown.height b.top b.height in
  { Box.left; top; width = w; height = h }

let covered length shown k =
  let first = k * length / shown in
  (first, Int.max first (ceil_div ((k + 1) * length) shown - 1))

let columns { shown; width; _ } = covered width shown.width
let rows { shown; height; _ } = covered height shown.height
