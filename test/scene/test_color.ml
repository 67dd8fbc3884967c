open Raylab_scene
open Test_support
open Build

let check = Alcotest.check Same.color
let a = rgb 0.5 1. 0.
let b = rgb 0.25 2. 8.

let test_arithmetic () =
  check "a + b" (rgb 0.75 3. 8.) (Color.add a b);
  check "3 a" (rgb 1.5 3. 0.) (Color.scale 3. a);
  check "a b" (rgb 0.125 2. 0.) (Color.multiply a b);
  check "black adds nothing" a (Color.add a Color.black);
  check "white multiplies by nothing" b (Color.multiply Color.white b)

let test_names () =
  let named name r g b =
    check name (rgb r g b) (List.assoc name Color.names)
  in
  named "black" 0. 0. 0.;
  named "white" 1. 1. 1.;
  named "red" 1. 0. 0.;
  named "green" 0. 1. 0.;
  named "blue" 0. 0. 1.;
  named "cyan" 0. 1. 1.;
  named "magenta" 1. 0. 1.;
  named "yellow" 1. 1. 0.;
  named "grey" 0.5 0.5 0.5;
  named "gray" 0.5 0.5 0.5;
  named "orange" 1. 0.5 0.;
  named "brown" 0.5 0.25 0.1;
  named "pink" 1. 0.6 0.75;
  named "purple" 0.5 0. 0.5;
  named "gold" 1. 0.78 0.3;
  named "silver" 0.75 0.75 0.78;
  Alcotest.(check int) "no more" 16 (List.length Color.names)

let test_bytes () =
  Alcotest.check Same.levels "each channel" (255, 128, 0)
    (Color.to_bytes (rgb 2. 0.5 (-1.)))

let test_luminance () =
  let check what expected c =
    Alcotest.check (Same.near 1e-15) what expected (Color.luminance c)
  in
  check "red" 0.2126 Color.red;
  check "green" 0.7152 Color.green;
  check "blue" 0.0722 Color.blue;
  (* 0.2126 + 0.7152 + 0.0722 = 1 *)
  check "white" 1. Color.white;
  (* 2 * 0.2126 + 0.5 * 0.0722 = 0.4252 + 0.0361 *)
  check "mixed" 0.4613 (rgb 2. 0. 0.5);
  Alcotest.(check bool)
    "never infinite" true
    (Float.is_finite (Color.luminance (grey max_float)))

let test_require () =
  Color.require "a colour" (rgb 0. max_float (-0.));
  List.iter
    (fun bad ->
      let refused what color =
        match Color.require "the colour" color with
        | () -> Alcotest.failf "%s: %g is let through" what bad
        | exception Invalid_argument message ->
            Expect.contains what ~part:"the colour" message;
            Expect.contains what ~part:what message
      in
      refused "red" (rgb bad 0. 0.);
      refused "green" (rgb 0. bad 0.);
      refused "blue" (rgb 0. 0. bad))
    [ nan; infinity; -1.; -5e-324 ]

let test_pp () =
  Expect.prints "channels" "rgb 1 0.5 0" Color.pp (rgb 1. 0.5 0.)

let suite =
  ( "Color",
    [
      Alcotest.test_case "arithmetic" `Quick test_arithmetic;
      Alcotest.test_case "names" `Quick test_names;
      Alcotest.test_case "to_bytes" `Quick test_bytes;
      Alcotest.test_case "luminance" `Quick test_luminance;
      Alcotest.test_case "require" `Quick test_require;
      Alcotest.test_case "pp" `Quick test_pp;
    ] )
