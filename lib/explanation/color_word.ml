open Raylab_scene

let clamp x = Float.max 0. (Float.min 1. x)

let grey v =
  if v > 0.9 then "white"
  else if v > 0.65 then "light grey"
  else if v > 0.3 then "grey"
  else "dark grey"

(* In degrees, for channels of which the largest is [v], and the smallest [d]
   less than that. *)
let hue { Color.r; g; b } v d =
  let sixth =
    if v = r then (g -. b) /. d
    else if v = g then 2. +. ((b -. r) /. d)
    else 4. +. ((r -. g) /. d)
  in
  if sixth < 0. then 60. *. (sixth +. 6.) else 60. *. sixth

let hues =
  [
    (345., "red");
    (290., "magenta");
    (255., "purple");
    (195., "blue");
    (165., "cyan");
    (70., "green");
    (42., "yellow");
    (15., "orange");
    (0., "red");
  ]

let of_hue h = snd (List.find (fun (from, _) -> h >= from) hues)
let dark = function "orange" -> "brown" | word -> "dark " ^ word

let light = function
  | "orange" -> "beige"
  | "red" -> "pink"
  | word -> "light " ^ word

let largest { Color.r; g; b } = Float.max r (Float.max g b)
let is_black c = largest c < 0.08

let of_color { Color.r; g; b } =
  let c = { Color.r = clamp r; g = clamp g; b = clamp b } in
  let v = largest c in
  let d = v -. Float.min c.r (Float.min c.g c.b) in
  if is_black c then "black"
  else if d < 0.15 *. v then grey v
  else
    let word = of_hue (hue c v d) in
    if v <= 0.5 then dark word else if d < 0.5 *. v then light word else word

let of_glow c =
  if (not (is_black c)) || Color.equal c Color.black then (false, of_color c)
  else
    let v = largest c in
    (true, of_color { r = c.r /. v; g = c.g /. v; b = c.b /. v })
