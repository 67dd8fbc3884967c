open Raylab_geometry
open Test_support
open Build

let box a b = Shape.box_between ~corner:a ~opposite:b

(* x from -1 to 1, y from 0 to 2, z from 4 to 7 *)
let some = box (v 1. 0. 7.) (v (-1.) 2. 4.)

let check what expected ray =
  Alcotest.(check (list (triple (Same.near 1e-14) int bool)))
    what expected (Ask.crossings some ray)

let along_z x y = ray (v x y 0.) (v 0. 0. 1.)

let test_crossings () =
  check "from front to back"
    [ (4., 4, true); (7., 5, false) ]
    (along_z 0.5 0.5);
  check "the other way"
    [ (-7., 5, true); (-4., 4, false) ]
    (ray (v 0.5 0.5 0.) (v 0. 0. (-1.)));
  (* 3 up for each 4 away: the top, at y = 2, is reached at z = 4 + 4 / 3 *)
  check "out at the top"
    [ (5., 4, true); (5. +. (5. /. 3.), 3, false) ]
    (ray (v 0. (-2.) 0.) (v 0. 3. 4.));
  check "beside it" [] (along_z 1.5 0.5);
  check "from inside"
    [ (-1., 0, true); (1., 1, false) ]
    (ray (v 0. 1. 5.) (v 1. 0. 0.))

(* A line in a face, along an edge or through a corner only is in the box. *)
let test_edges () =
  check "in the top" [ (4., 4, true); (7., 5, false) ] (along_z 0. 2.);
  check "in the bottom" [ (4., 4, true); (7., 5, false) ] (along_z 0. 0.);
  check "along an edge" [ (4., 4, true); (7., 5, false) ] (along_z 1. 2.);
  check "just above" [] (along_z 0. 2.0000001);
  let touch = ray (v (-2.) 2. 3.) (v 1. 0. 1.) in
  check "in the top, across"
    [ (sqrt 2., 0, true); (3. *. sqrt 2., 1, false) ]
    touch;
  let edge = sqrt 2. in
  check "an edge only"
    [ (edge, 0, true); (edge, 4, false) ]
    (ray (v (-2.) 1. 5.) (v 1. 0. (-1.)));
  check "backwards along -0"
    [ (4., 4, true); (7., 5, false) ]
    (ray (v 0. 1. 0.) (v (-0.) (-0.) 1.))

(* A spot has exactly the coordinate of its face. *)
let test_settle () =
  let face part reach normal =
    let spot = Ask.spot ~part some ~reach (ray (v 0.3 1. 0.) (v 0.1 0.2 1.)) in
    Alcotest.check Same.direction "outward" normal (Spot.normal spot);
    (Spot.point spot, Spot.own spot)
  in
  let point, own = face 4 4.1 (dir 0. 0. (-1.)) in
  Alcotest.check Same.number "on the front" 4. point.z;
  Alcotest.check Same.vec3 "its own" point own;
  let point, _ = face 3 5.2 (dir 0. 1. 0.) in
  Alcotest.check Same.number "on the top" 2. point.y;
  let point, _ = face 1 50. (dir 1. 0. 0.) in
  Alcotest.check Same.vec3 "not beyond an edge" (v 1. 2. 7.) point

let test_depth () =
  let check what expected point =
    Alcotest.check (Same.near 1e-15) what expected (Shape.depth some point)
  in
  check "below the top" 0.25 (v 0. 1.75 5.);
  check "beside" (-1.) (v 2. 1. 5.);
  check "on it" 0. (v 0. 1. 4.)

let test_size () =
  let check what expected small =
    Alcotest.(check (list (Same.near 1e-14)))
      what expected
      (Shape.intersections small (along_z 0. 0.))
  in
  let cube k = box (v (-.k) (-.k) (-.k)) (v k k k) in
  check "tiny" [ -1e-9; 1e-9 ] (cube 1e-9);
  check "huge" [ -1e9; 1e9 ] (cube 1e9);
  check "beyond squares" [ -1e300; 1e300 ] (cube 1e300)

(* Turned by a right angle a box is a box, else it is placed. *)
let test_turned () =
  let turned angle sin cos =
    let axis = dir 0. 1. 0. in
    Shape.transformed
      (Change.of_modifiers [ Rotated { axis; angle; sin; cos } ])
      some
  in
  (* with the thumb up, z goes to x and x to -z *)
  Alcotest.(check bool)
    "a box" true
    (Shape.equal (turned 90. 1. 0.) (box (v 4. 0. (-1.)) (v 7. 2. 1.)));
  Alcotest.(check bool)
    "placed" true
    (match turned 30. 0.5 (sqrt 0.75) with Placed _ -> true | _ -> false)

let test_told () =
  Expect.prints "pp" "box (-1, 0, 4) to (1, 2, 7)" Shape.pp some;
  Alcotest.(check (list (option string)))
    "faces"
    [
      Some "left side"; Some "right side"; Some "bottom"; Some "top";
      Some "front"; Some "back";
    ]
    (List.init 6 (Shape.part some))
[@@ocamlformat "disable"]

let test_invalid () =
  Expect.invalid "flat" (fun () -> box (v 0. 0. 0.) (v 1. 0. 1.));
  Expect.invalid "NaN" (fun () -> box (v 0. nan 0.) (v 1. 1. 1.));
  Expect.invalid "infinite" (fun () -> box (v 0. 0. 0.) (v 1. infinity 1.))

let suite =
  ( "Box",
    [
      Alcotest.test_case "crossings" `Quick test_crossings;
      Alcotest.test_case "edges" `Quick test_edges;
      Alcotest.test_case "settle" `Quick test_settle;
      Alcotest.test_case "depth" `Quick test_depth;
      Alcotest.test_case "any size" `Quick test_size;
      Alcotest.test_case "turned" `Quick test_turned;
      Alcotest.test_case "told" `Quick test_told;
      Alcotest.test_case "invalid" `Quick test_invalid;
    ] )
