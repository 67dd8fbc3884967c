(* The words of the prompt are those of the language. *)

open Raylab_language
open Raylab_toplevel

(* The colour that the language makes of [text]. *)
let written text =
  let scene =
    "imWidth 4 imHeight 3 canvWidth 4 canvHeight 3 depth 4 bcolor " ^ text
  in
  let sources = Raylab_source.Sources.make ~name:"a.scene" scene in
  match Scene_file.parse sources with
  | Ok { background = Plain color; _ } -> color
  | Ok _ | Error _ -> Alcotest.failf "%s is no colour" text

let check text color =
  Alcotest.check Test_support.Same.color text (written text) color

let test_colors () =
  check "grey" Build.grey;
  check "orange" Build.orange;
  check "brown" Build.brown;
  check "pink" Build.pink;
  check "purple" Build.purple;
  check "gold" Build.gold;
  check "silver" Build.silver;
  check "[hsv(200, 0.3, 0.8)]" (Build.hsv 200. 0.3 0.8)

let test_numbers () =
  let point = Build.vec 0.3 1.7 (-2.2) in
  check "[abs(noise([0.3, 1.7, -2.2])), random(7), 0]"
    (Build.rgb (abs_float (Build.noise point)) (Build.random 7.) 0.);
  check "[abs(turbulence([0.3, 1.7, -2.2], 3)), 0, 0]"
    (Build.rgb (abs_float (Build.turbulence point 3)) 0. 0.)

(* The objects that the language makes of [text]. *)
let objects text =
  let scene =
    "imWidth 4 imHeight 3 canvWidth 4 canvHeight 3 depth 4 " ^ text
  in
  let sources = Raylab_source.Sources.make ~name:"a.scene" scene in
  match Scene_file.parse sources with
  | Ok { objects; _ } -> objects
  | Error _ -> Alcotest.failf "%s is no object" text

let test_solids () =
  let open Build in
  let ball z = sphere (vec 0. 0. z) 1. reflective in
  let check text o =
    Alcotest.(check (list Test_support.Same.object_)) text (objects text) [ o ]
  in
  let two = "sphere 0 0 4 1 reflective sphere 0 0 5 1 reflective end" in
  check ("union " ^ two) (union [ ball 4.; ball 5. ]);
  check ("intersection " ^ two) (intersection [ ball 4.; ball 5. ]);
  check ("difference " ^ two) (difference [ ball 4.; ball 5. ]);
  check "sphere 0 0 4 1 reflective shadowless" (shadowless (ball 4.))

let suite =
  ( "Build",
    [
      Alcotest.test_case "colours" `Quick test_colors;
      Alcotest.test_case "numbers" `Quick test_numbers;
      Alcotest.test_case "solids" `Quick test_solids;
    ] )
