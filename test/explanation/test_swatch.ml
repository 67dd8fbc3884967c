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
  check "NO_COLOR" "none" (detect [ xterm; truecolor; ("NO_COLOR", "1") ]);
  check "NO_COLOR, but empty" "palette" (detect [ xterm; ("NO_COLOR", "") ])

let test_print () =
  let check what expected swatch color =
    Alcotest.(check string)
      what expected
      (Format.asprintf "%a" (Swatch.pp_with swatch) color)
  in
  check "none" "" Swatch.None Color.red;
  check "24 bits" " \027[48;2;255;128;0m  \027[0m" Swatch.True_color
    (rgb 2. 0.5 0.);
  check "black" " \027[48;5;16m  \027[0m" Swatch.Palette Color.black;
  check "white" " \027[48;5;231m  \027[0m" Swatch.Palette Color.white;
  check "red" " \027[48;5;196m  \027[0m" Swatch.Palette Color.red;
  check "grey" " \027[48;5;244m  \027[0m" Swatch.Palette (grey 0.5)

let suite =
  ( "Swatch",
    [
      Alcotest.test_case "detect" `Quick test_detect;
      Alcotest.test_case "print" `Quick test_print;
    ] )
