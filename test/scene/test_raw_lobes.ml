open Raylab_geometry
open Raylab_scene
open Test_support
open Build

let check what expected ?(at = 0) found =
  Alcotest.check Same.lobes what expected (Raw_lobes.read found at)

let lobes ?(emission = Color.black) ?(albedo = Color.black)
    ?(mirror = Color.black) () =
  { Lobes.emission; albedo; mirror }

(* What [surface] denotes, in a row, with those that it needs after it. *)
let row surface =
  let numbers = Raw_lobes.create ~rows:(Surface.levels surface) in
  Surface.write surface (Spot.create ()) numbers 0;
  numbers

let matt r g b = Surface.diffusive (rgb r g b)
let glow r g b = Surface.luminous (rgb r g b)

(* 2 (1, 2, 3) + 0.5 (4, 0, 2) = (4, 4, 7). *)
let test_add () =
  let sum = Raw_lobes.create ~rows:2 in
  let add weight surface =
    Surface.write surface (Spot.create ()) sum 9;
    Raw_lobes.add_next sum 0 weight
  in
  check "at first" (lobes ()) sum;
  add 2. (matt 1. 2. 3.);
  add 0.5 (matt 4. 0. 2.);
  add 3. (glow 1. 0. 0.5);
  add 0.25 Surface.reflective;
  check "lobe by lobe"
    (lobes ~albedo:(rgb 4. 4. 7.) ~emission:(rgb 3. 0. 1.5) ~mirror:(grey 0.25)
       ())
    sum;
  Raw_lobes.clear sum 0;
  check "cleared" (lobes ()) sum;
  (* 1e200 * 1e200 is no double, nor is the sum of two of the largest *)
  add 1e200 (matt 1e200 1. 0.);
  check "a product" (lobes ~albedo:(rgb max_float 1e200 0.) ()) sum;
  add 1. (matt max_float 0. 0.);
  add max_float Surface.reflective;
  add max_float Surface.reflective;
  check "a sum"
    (lobes ~albedo:(rgb max_float 1e200 0.) ~mirror:(grey max_float) ())
    sum

(* 2 (0.5 mirror + 3 (1, 2, 0)) + 4 glow, the outer mix and the inner one
   last: albedo 4 * 2 * 3 (1, 2, 0), mirror 4 * 2 * 0.5. *)
let nested =
  Surface.mixed
    [
      (0.5, glow 4. 0. 0.);
      ( 4.,
        Surface.mixed
          [
            (1., glow 0. 1. 0.);
            ( 2.,
              Surface.mixed [ (0.5, Surface.reflective); (3., matt 1. 2. 0.) ]
            );
          ] );
    ]

let expected =
  lobes ~emission:(rgb 2. 4. 0.) ~albedo:(rgb 24. 48. 0.) ~mirror:(grey 4.) ()

let test_nested () =
  Alcotest.(check int) "levels" 4 (Surface.levels nested);
  Alcotest.(check int) "of no mix" 1 (Surface.levels Surface.reflective);
  check "by hand" expected (row nested)

(* Rows that were used before, and not from the first on. *)
let test_levels () =
  let numbers = Array.make (6 * 9) 9. in
  let write surface = Surface.write surface (Spot.create ()) numbers 18 in
  write nested;
  check "in its row" expected ~at:18 numbers;
  write (glow 1. 2. 3.);
  check "anew" (lobes ~emission:(rgb 1. 2. 3.) ()) ~at:18 numbers;
  write nested;
  check "and again" expected ~at:18 numbers;
  let nine = grey 9. in
  check "before it nothing changes"
    (lobes ~emission:nine ~albedo:nine ~mirror:nine ())
    ~at:9 numbers

let suite =
  ( "Raw_lobes",
    [
      Alcotest.test_case "add" `Quick test_add;
      Alcotest.test_case "nested mixes" `Quick test_nested;
      Alcotest.test_case "levels" `Quick test_levels;
    ] )
