open Raylab_scene
open Raylab_explanation
open Test_support
open Build

let detect ?(is_terminal = true) environment =
  Swatch.detect ~is_terminal (fun name -> List.assoc_opt name environment)

let word = function
  | Swatch.None -> "none"
  | Palette -> "palette"
  | True_color -> "true colour"

let test_detect () =
  let check what expected swatch =
    Alcotest.(check string) what expected (word swatch)
  in
  let xterm = ("TERM", "xterm-256color")
  and truecolor = ("COLORTERM", "truecolor") in
  check "256 colours" "palette" (detect [ xterm ]);
  check "24 bits" "true colour" (detect [ xterm; truecolor ]);
  check "24 bits, too" "true colour" (detect [ xterm; ("COLORTERM", "24bit") ]);
  check "a pipe" "none" (detect ~is_terminal:false [ xterm; truecolor ]);
  check "dumb" "none" (detect [ ("TERM", "dumb"); truecolor ]);
  check "no TERM" "none" (detect [ truecolor ]);
  let screen = ("TERM", "screen.xterm-256color") in
  check "GNU screen" "palette" (detect [ screen; truecolor ]);
  check "tmux" "true colour"
    (detect [ ("TERM", "screen-256color"); ("TMUX", "/tmp/a,1,0"); truecolor ]);
  check "NO_COLOR" "none" (detect [ xterm; truecolor; ("NO_COLOR", "1") ]);
  check "NO_COLOR, but empty" "palette" (detect [ xterm; ("NO_COLOR", "") ])

let print swatch = Format.asprintf "%a" (Swatch.pp_with swatch)

let test_print () =
  let check what expected swatch color =
    Alcotest.(check string) what expected (print swatch color)
  in
  check "none" "" Swatch.None Color.red;
  check "24 bits" " \027[48;2;255;128;0m  \027[0m" Swatch.True_color
    (rgb 2. 0.5 0.);
  check "black" " \027[48;5;16m  \027[0m" Swatch.Palette Color.black;
  check "white" " \027[48;5;231m  \027[0m" Swatch.Palette Color.white;
  check "red" " \027[48;5;196m  \027[0m" Swatch.Palette Color.red;
  check "grey" " \027[48;5;244m  \027[0m" Swatch.Palette (grey 0.5)

let exact =
  Property.holds "24 bits are the picture's" ~print:(Property.show Color.pp)
    (Generate.color Generate.extreme) (fun color ->
      let r, g, b = Color.to_bytes color in
      print True_color color
      = Printf.sprintf " \027[48;2;%d;%d;%dm  \027[0m" r g b)

(* {1 The palette} *)

let entry color = Scanf.sscanf (print Palette color) " \027[48;5;%dm" Fun.id

(* What a terminal shows: a digit of the cube is 0, 95, 135, 175, 215 or 255. *)
let shown entry =
  let level k = if k = 0 then 0 else 55 + (40 * k) in
  let r, g, b =
    if entry < 232 then
      let k = entry - 16 in
      (level (k / 36), level (k / 6 mod 6), level (k mod 6))
    else
      let grey = 8 + (10 * (entry - 232)) in
      (grey, grey, grey)
  in
  let channel byte = float_of_int byte /. 255. in
  rgb (channel r) (channel g) (channel b)

(* The nearest of all would be 58, an olive, for the dark browns. *)
let test_browns () =
  List.iter
    (fun (r, g, b) ->
      Alcotest.(check int)
        (Printf.sprintf "%g %g %g" r g b)
        94
        (entry (rgb r g b)))
    [ (0.4, 0.32, 0.12); (0.4, 0.24, 0.); (0.5, 0.4, 0.15) ];
  Alcotest.(check int) "beige" 137 (entry (rgb 0.7 0.62 0.5))

let no_wrong_hue =
  Property.holds "no hue is far from the colour's" ~count:2000
    ~print:(Property.show Color.pp)
    (Generate.color (QCheck2.Gen.float_bound_inclusive 1.))
    (fun color ->
      match (Color_word.hue color, Color_word.hue (shown (entry color))) with
      | Some h, Some h' ->
          let apart = Float.abs (h -. h') in
          (* a byte is not quite the channel *)
          Float.min apart (360. -. apart) <= 18.
      | None, Some _ -> false
      | _, None -> true)

let suite =
  ( "Swatch",
    [
      Alcotest.test_case "detect" `Quick test_detect;
      Alcotest.test_case "print" `Quick test_print;
      Alcotest.test_case "browns" `Quick test_browns;
      exact;
      no_wrong_hue;
    ] )
