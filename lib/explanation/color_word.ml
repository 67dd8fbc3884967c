open Raylab_scene

let clamp x = Float.max 0. (Float.min 1. x)

let grey v =
  if v > 0.9 then "white"
  else if v > 0.65 then "light grey"
  else if v > 0.3 then "grey"
  else "dark grey"

(* For channels of which the largest is [v], and the smallest [d] less. *)
let degrees { Color.r; g; b } v d =
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
let is_brown h = h >= 15. && h < 50.
let dark h = if is_brown h then "brown" else "dark " ^ of_hue h

let light h =
  match of_hue h with
  | "orange" -> "beige"
  | "red" -> "pink"
  | word -> "light " ^ word

let largest { Color.r; g; b } = Float.max r (Float.max g b)
let is_black c = largest c < 0.08

(* As a picture shows [c]: its hue, if it has one, its largest channel, and how
   much less the smallest is. *)
let measure { Color.r; g; b } =
  let c = { Color.r = clamp r; g = clamp g; b = clamp b } in
  let v = largest c in
  let d = v -. Float.min c.r (Float.min c.g c.b) in
  let has_hue = not (is_black c || d < 0.15 *. v) in
  ((if has_hue then Some (degrees c v d) else None), v, d)

let hue c =
  let h, _, _ = measure c in
  h

let of_color c =
  match measure c with
  | None, v, _ -> if is_black c then "black" else grey v
  | Some h, v, d ->
      if v <= 0.5 then dark h else if d < 0.5 *. v then light h else of_hue h

let of_glow c =
  if (not (is_black c)) || Color.equal c Color.black then (false, of_color c)
  else
    let v = largest c in
    (true, of_color { r = c.r /. v; g = c.g /. v; b = c.b /. v })
