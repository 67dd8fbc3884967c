open Raylab_scene

type t = None | Palette | True_color

(* GNU screen takes a colour of 24 bits for other colours, though it hands on
   the COLORTERM of the terminal around it. tmux, which does not, may have the
   same TERM. *)
let is_screen value =
  String.starts_with ~prefix:"screen" (value "TERM") && value "TMUX" = ""

let detect ~is_terminal getenv =
  let value name = Option.value (getenv name) ~default:"" in
  if (not is_terminal) || value "NO_COLOR" <> "" then None
  else
    match (value "TERM", value "COLORTERM") with
    | ("" | "dumb"), _ -> None
    | _, ("truecolor" | "24bit") when not (is_screen value) -> True_color
    | _ -> Palette

(* {1 The palette} *)

type entry = { number : int; bytes : int * int * int; hue : float option }

let hue_of_bytes (r, g, b) =
  let channel byte = float_of_int byte /. 255. in
  Color_word.hue (Color.make (channel r) (channel g) (channel b))

(* From 16 on a cube of 6 x 6 x 6 colours, and after it 24 greys. Those before
   16 are every terminal's own. *)
let palette =
  let levels = [| 0; 95; 135; 175; 215; 255 |] in
  let bytes k =
    if k < 216 then (levels.(k / 36), levels.(k / 6 mod 6), levels.(k mod 6))
    else
      let grey = 8 + (10 * (k - 216)) in
      (grey, grey, grey)
  in
  List.init 240 (fun k ->
      let bytes = bytes k in
      { number = 16 + k; bytes; hue = hue_of_bytes bytes })

let distance (r, g, b) (r', g', b') =
  let square d = d * d in
  square (r - r') + square (g - g') + square (b - b')

let is_near h h' =
  let apart = Float.abs (h -. h') in
  Float.min apart (360. -. apart) <= 15.

(* There are few dark colours in the palette: the one nearest to most browns is
   olive. A wrong hue looks more wrong than a wrong brightness, and a grey, if
   it is near, not wrong. *)
let cost bytes hue entry =
  let d = distance bytes entry.bytes in
  match (hue, entry.hue) with
  | Option.None, Option.None -> d
  | Some _, None -> 2 * d
  | None, Some _ -> max_int
  | Some h, Some h' -> if is_near h h' then d else max_int

let palette_entry bytes =
  let hue = hue_of_bytes bytes in
  let nearer a b = if cost bytes hue b < cost bytes hue a then b else a in
  (List.fold_left nearer (List.hd palette) palette).number

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
