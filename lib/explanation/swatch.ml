open Raylab_scene

type t = None | Palette | True_color

let detect ~is_terminal getenv =
  let value name = Option.value (getenv name) ~default:"" in
  if (not is_terminal) || value "NO_COLOR" <> "" then None
  else
    match (value "TERM", value "COLORTERM") with
    | ("" | "dumb"), _ -> None
    | _, ("truecolor" | "24bit") -> True_color
    | _ -> Palette

(* The palette has a cube of 6 x 6 x 6 colours, of these levels, from 16 on, and
   after it 24 greys from 8 to 238. *)
let levels = [| 0; 95; 135; 175; 215; 255 |]

let nearest_level v =
  let best = ref 0 in
  Array.iteri
    (fun i level ->
      if abs (level - v) < abs (levels.(!best) - v) then best := i)
    levels;
  !best

let palette_entry (r, g, b) =
  let i = nearest_level r and j = nearest_level g and k = nearest_level b in
  let grey = Int.max 0 (Int.min 23 ((((r + g + b) / 3) - 3) / 10)) in
  let distance r' g' b' =
    let square d = d * d in
    square (r - r') + square (g - g') + square (b - b')
  in
  let level = 8 + (10 * grey) in
  if distance level level level < distance levels.(i) levels.(j) levels.(k)
  then 232 + grey
  else 16 + (36 * i) + (6 * j) + k

let pp_with swatch ppf color =
  let r, g, b = Color.to_bytes color in
  let patch background =
    Format.pp_print_string ppf " ";
    (* to the formatter it is two columns wide *)
    Format.pp_print_as ppf 2 (Printf.sprintf "\027[48;%sm  \027[0m" background)
  in
  match swatch with
  | None -> ()
  | Palette -> patch (Printf.sprintf "5;%d" (palette_entry (r, g, b)))
  | True_color -> patch (Printf.sprintf "2;%d;%d;%d" r g b)
