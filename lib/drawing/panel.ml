open Raylab_geometry

type side = Above | Beside

type t = {
  side : side;
  left : float;
  top : float;
  width : float;
  height : float;
  scale : float;
  space : Box3.t;
}

let across side { Vec3.x; z; _ } = match side with Above -> x | Beside -> z
let up side { Vec3.y; z; _ } = match side with Above -> z | Beside -> y

let towards_viewer side { Vec3.x; y; _ } =
  match side with Above -> y | Beside -> x

let point { side; left; top; height; scale; space; _ } p =
  ( left +. (scale *. (across side p -. across side space.low)),
    top +. height -. (scale *. (up side p -. up side space.low)) )

let box { left; top; width; height; _ } =
  { Rectangle.left; top; right = left +. width; bottom = top +. height }

let shows panel place = Rectangle.contains (box panel) place

let middle { left; top; width; height; _ } =
  (left +. (width /. 2.), top +. (height /. 2.))

let clip panel origin direction range =
  let { side; left; top; width; height; scale; _ } = panel in
  let x, y = point panel origin in
  let dx = scale *. across side direction
  and dy = -.scale *. up side direction in
  let range = Clip.narrow range ~from:x ~step:dx left (left +. width) in
  let t0, t1 = Clip.narrow range ~from:y ~step:dy top (top +. height) in
  let at t = (x +. (t *. dx), y +. (t *. dy)) in
  if t0 < t1 && Float.is_finite t0 && Float.is_finite t1 then
    Some (at t0, at t1)
  else None

let segment panel origin direction length =
  clip panel origin direction (0., length)

let line panel p direction = clip panel p direction (neg_infinity, infinity)
