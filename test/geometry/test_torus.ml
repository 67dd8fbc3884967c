open Raylab_geometry
open Test_support
open Build

(* Around the y axis through (0, 0, 10): the tube is from 2 to 4 away. *)
let torus =
  Shape.torus ~centre:(v 0. 0. 10.) ~axis:(v 0. 2. 0.) ~ring:3. ~tube:1.

let check what expected ray =
  Alcotest.(check (list (triple (Same.near 1e-13) int bool)))
    what expected (Ask.crossings torus ray)

let along_z x y = ray (v x y 0.) (v 0. 0. 1.)
let down x z = ray (v x 5. z) (v 0. (-1.) 0.)

let test_crossings () =
  check "in, hole, out"
    [ (6., 0, true); (8., 0, false); (12., 0, true); (14., 0, false) ]
    (along_z 0. 0.);
  (* at height 0.6 the tube is 0.8 to each side of its middle *)
  check "off the middle"
    [ (6.2, 0, true); (7.8, 0, false); (12.2, 0, true); (13.8, 0, false) ]
    (along_z 0. 0.6);
  check "down through the tube" [ (4., 0, true); (6., 0, false) ] (down 0. 7.);
  (* sqrt (16 - 9) *)
  check "within the tube"
    [ (10. -. sqrt 7., 0, true); (10. +. sqrt 7., 0, false) ]
    (along_z 3. 0.);
  check "through the hole" [] (down 0. 10.);
  check "through the hole, aside" [] (down 1.9 10.);
  check "above" [] (along_z 0. 1.1);
  check "beside" [] (along_z 4.1 0.);
  check "from its hole"
    [ (-4., 0, true); (-2., 0, false); (2., 0, true); (4., 0, false) ]
    (ray (v 0. 0. 10.) (v 1. 0. 0.))

let test_settle () =
  let spot = Ask.spot torus ~reach:5.9 (along_z 0. 0.) in
  Alcotest.check (Same.vec3_near 1e-14) "point" (v 0. 0. 6.) (Spot.point spot);
  Alcotest.check
    (Same.direction_near 1e-14)
    "outward" (dir 0. 0. (-1.)) (Spot.normal spot);
  Alcotest.check Same.number "size" 4. spot.size;
  let inside = Ask.spot torus ~reach:8. (along_z 0. 0.) in
  Alcotest.check
    (Same.direction_near 1e-14)
    "into the hole" (dir 0. 0. 1.) (Spot.normal inside)

(* From far away, and of tubes as thin as a hair. *)
let test_size () =
  let far = ray (v 0. 0.6 (-1e7)) (v 0. 0. 1.) in
  Alcotest.(check (list (Same.near 1e-7)))
    "from far away"
    (List.map (( +. ) 1e7) [ 6.2; 7.8; 12.2; 13.8 ])
    (Shape.intersections torus far);
  List.iter
    (fun k ->
      let big =
        Shape.torus
          ~centre:(v 0. 0. (10. *. k))
          ~axis:(v 0. 1. 0.) ~ring:(3. *. k) ~tube:k
      in
      Alcotest.(check (list (Same.near (1e-13 *. k))))
        (Printf.sprintf "times %g" k)
        (List.map (( *. ) k) [ 6.2; 7.8; 12.2; 13.8 ])
        (Shape.intersections big (along_z 0. (0.6 *. k))))
    [ 1e-9; 1e9; 1e100 ];
  let thin tube =
    Shape.torus ~centre:(v 0. 0. 10.) ~axis:(v 0. 1. 0.) ~ring:3. ~tube
  in
  List.iter
    (fun tube ->
      Alcotest.(check (list (Same.near 1e-14)))
        (Printf.sprintf "a tube of %g" tube)
        [ 7. -. tube; 7. +. tube; 13. -. tube; 13. +. tube ]
        (Shape.intersections (thin tube) (along_z 0. 0.)))
    [ 0.1; 1e-4; 1e-7; 1e-9 ]

(* One of no hole is touched in its centre by the line along its axis. *)
let test_horn () =
  let horn =
    Shape.torus ~centre:(v 0. 0. 10.) ~axis:(v 0. 1. 0.) ~ring:1. ~tube:1.
  in
  Alcotest.(check (list (Same.near 1e-7)))
    "through its centre" [ 8.; 10.; 10.; 12. ]
    (match Shape.intersections horn (along_z 0. 0.) with
    | [ a; b ] -> [ a; 10.; 10.; b ]
    | all -> all)

let test_depth () =
  let check what expected point =
    Alcotest.check (Same.near 1e-14) what expected (Shape.depth torus point)
  in
  check "in the middle of the tube" 1. (v 3. 0. 10.);
  check "in the hole" (-2.) (v 0. 0. 10.);
  check "above the tube" (-1.) (v 0. 2. 7.)

let test_told () =
  Expect.prints "pp" "torus centre (0, 0, 10) axis (0, 1, 0) ring 3 tube 1"
    Shape.pp torus

let test_invalid () =
  let torus ring tube () =
    Shape.torus ~centre:Vec3.zero ~axis:(v 0. 1. 0.) ~ring ~tube
  in
  Expect.invalid "no ring" (torus 0. 1.);
  Expect.invalid "no tube" (torus 1. 0.);
  Expect.invalid "too thick" (torus 1. 1.5);
  Expect.invalid "NaN" (torus nan 1.);
  Expect.invalid "no axis" (fun () ->
      Shape.torus ~centre:Vec3.zero ~axis:Vec3.zero ~ring:2. ~tube:1.)

let suite =
  ( "Torus",
    [
      Alcotest.test_case "crossings" `Quick test_crossings;
      Alcotest.test_case "settle" `Quick test_settle;
      Alcotest.test_case "any size" `Quick test_size;
      Alcotest.test_case "without a hole" `Quick test_horn;
      Alcotest.test_case "depth" `Quick test_depth;
      Alcotest.test_case "told" `Quick test_told;
      Alcotest.test_case "invalid" `Quick test_invalid;
    ] )
