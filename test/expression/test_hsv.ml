open Raylab_expression
open Test_support
open Build

let check name expected h s value =
  Alcotest.check Same.vec3 name expected (Hsv.color ~h ~s ~v:value)

let test_corners () =
  check "red" (v 1. 0. 0.) 0. 1. 1.;
  check "yellow" (v 1. 1. 0.) 60. 1. 1.;
  check "green" (v 0. 1. 0.) 120. 1. 1.;
  check "cyan" (v 0. 1. 1.) 180. 1. 1.;
  check "blue" (v 0. 0. 1.) 240. 1. 1.;
  check "magenta" (v 1. 0. 1.) 300. 1. 1.;
  check "white" (v 1. 1. 1.) 77. 0. 1.;
  check "black" (v 0. 0. 0.) 77. 1. 0.

(* Halfway from red to yellow; half of it grey; and half as light. *)
let test_between () =
  check "orange" (v 1. 0.5 0.) 30. 1. 1.;
  check "pale orange" (v 1. 0.75 0.5) 30. 0.5 1.;
  check "dark orange" (v 0.5 0.25 0.) 30. 1. 0.5;
  check "bright orange" (v 3. 1.5 0.) 30. 1. 3.

let test_circle () =
  check "once around" (v 1. 0.5 0.) 390. 1. 1.;
  check "the other way" (v 1. 0. 0.5) (-30.) 1. 1.;
  check "often" (v 1. 0.5 0.) (30. -. 36e9) 1. 1.

let suite =
  ( "Hsv",
    [
      Alcotest.test_case "corners" `Quick test_corners;
      Alcotest.test_case "between" `Quick test_between;
      Alcotest.test_case "circle" `Quick test_circle;
    ] )
