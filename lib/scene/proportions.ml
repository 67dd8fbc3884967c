let of_canvas { Camera.canvas_width; canvas_height; _ } =
  canvas_width /. canvas_height

let distortion ({ Camera.width; height; _ } as camera) =
  let width = float_of_int width
  and height = float_of_int height
  and right = of_canvas camera in
  let stretch = right /. (width /. height) in
  let is_near = 0.99 <= stretch && stretch <= 1.01
  and is_rounded =
    Float.abs (height -. (width /. right)) <= 0.5
    || Float.abs (width -. (height *. right)) <= 0.5
  in
  if is_near || is_rounded then None
  else
    Some
      (Printf.sprintf "%.3g times as %s as it should"
         (if stretch < 1. then 1. /. stretch else stretch)
         (if stretch < 1. then "wide" else "high"))

let warnings camera =
  let distorted how =
    let text =
      "canvas and picture differ in proportions: the picture looks " ^ how
    in
    { Warning.text; about = [] }
  in
  Option.to_list (Option.map distorted (distortion camera))

let fitting_height ({ Camera.width; _ } as camera) =
  let height = Float.round (float_of_int width /. of_canvas camera) in
  int_of_float (Float.max 1. (Float.min height (float_of_int Camera.max_size)))
