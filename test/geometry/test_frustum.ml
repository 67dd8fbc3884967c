open Raylab_geometry
open Test_support
open Build

(* Around the y axis, 2 high. *)
let cylinder = Shape.cylinder (v 0. 0. 5.) (v 0. 2. 5.) ~radius:1.
let cone = Shape.cone (v 0. 0. 5.) 1. (v 0. 2. 5.) 0.

let check shape what expected ray =
  Alcotest.(check (list (triple (Same.near 1e-13) int bool)))
    what expected (Ask.crossings shape ray)

let along_z x y = ray (v x y 0.) (v 0. 0. 1.)
let down x z = ray (v x 5. z) (v 0. (-1.) 0.)

let test_cylinder () =
  let check = check cylinder in
  check "through the wall" [ (4., 0, true); (6., 0, false) ] (along_z 0. 1.);
  (* half a chord at 0.6 from the axis is 0.8 *)
  check "off the axis" [ (4.2, 0, true); (5.8, 0, false) ] (along_z 0.6 1.);
  check "through both ends" [ (3., 2, true); (5., 1, false) ] (down 0.5 5.);
  check "along the axis" [ (3., 2, true); (5., 1, false) ] (down 0. 5.);
  check "above" [] (along_z 0. 2.5);
  check "beside" [] (along_z 1.5 1.);
  check "parallel, outside" [] (down 1.5 5.);
  (* from z = 4 at the wall, 2 up and 2 away, to the upper end in the middle *)
  check "wall, then end"
    [ (sqrt 2., 0, true); (3. *. sqrt 2. /. 2., 2, false) ]
    (ray (v 0. 0.5 3.) (v 0. 1. 1.))

let test_cylinder_edges () =
  let check = check cylinder in
  check "in an end" [ (4., 0, true); (6., 0, false) ] (along_z 0. 2.);
  check "just above" [] (along_z 0. 2.0000001);
  check "a tangent" [ (5., 0, true); (5., 0, false) ] (along_z 1. 1.)

(* At half the height the radius is a half. *)
let test_cone () =
  let check = check cone in
  check "half way up" [ (4.5, 0, true); (5.5, 0, false) ] (along_z 0. 1.);
  check "down to the base" [ (4., 0, true); (5., 1, false) ] (down 0.5 5.);
  check "down the axis" [ (3., 0, true); (5., 1, false) ] (down 0. 5.);
  check "up the axis"
    [ (3., 1, true); (5., 0, false) ]
    (ray (v 0. (-3.) 5.) (v 0. 1. 0.));
  check "not the mirror image" [] (along_z 0. 3.);
  (* parallel to the wall, which falls 2 for each 1 away from the axis *)
  check "as steep as the wall"
    [ (sqrt 5. /. 4., 0, true); (sqrt 5., 1, false) ]
    (ray (v 0. 2. 4.5) (v 0. (-2.) 1.))

let test_frustum () =
  let frustum = Shape.cone (v 0. 0. 5.) 0.5 (v 0. 2. 5.) 1.5 in
  check frustum "half way up" [ (4., 0, true); (6., 0, false) ] (along_z 0. 1.);
  check frustum "down beside the lower end"
    [ (3., 2, true); (4., 0, false) ]
    (down 1. 5.)

let test_settle () =
  let settled shape part reach ray =
    let spot = Ask.spot ~part shape ~reach ray in
    (Spot.point spot, Spot.normal spot)
  in
  let point, normal = settled cylinder 0 3.9 (along_z 0. 1.) in
  Alcotest.check (Same.vec3_near 1e-15) "on the wall" (v 0. 1. 4.) point;
  Alcotest.check (Same.direction_near 1e-15) "outward" (dir 0. 0. (-1.)) normal;
  let point, normal = settled cylinder 2 3. (down 0.3 5.1) in
  Alcotest.check Same.number "exactly on the end" 2. point.y;
  Alcotest.check Same.direction "up" (dir 0. 1. 0.) normal;
  let point, normal = settled cone 0 4.5 (along_z 0. 1.) in
  Alcotest.check (Same.vec3_near 1e-15) "on the cone" (v 0. 1. 4.5) point;
  Alcotest.check
    (Same.direction_near 1e-15)
    "half as far up as outward" (dir 0. 1. (-2.)) normal;
  let point, normal = settled cone 0 3. (down 0. 5.) in
  Alcotest.check (Same.vec3_near 1e-15) "at the tip" (v 0. 2. 5.) point;
  Alcotest.check Same.direction "upwards" (dir 0. 1. 0.) normal

(* The same shape, k times as large and as far away, and seen from far. *)
let test_size () =
  List.iter
    (fun k ->
      let at y = v 0. (k *. y) (k *. 5.) in
      let cylinder = Shape.cylinder (at 0.) (at 2.) ~radius:k in
      Alcotest.(check (list (Same.near (1e-13 *. k))))
        (Printf.sprintf "times %g" k)
        [ 4. *. k; 6. *. k ]
        (Shape.intersections cylinder (along_z 0. k)))
    [ 1e-9; 1e-3; 1e9; 1e100 ];
  let far = ray (v 0.6 1. (-1e7)) (v 0. 0. 1.) in
  Alcotest.(check (list (Same.near 1e-8)))
    "from far away"
    [ 1e7 +. 4.2; 1e7 +. 5.8 ]
    (Shape.intersections cylinder far)

let test_depth () =
  let check what expected shape point =
    Alcotest.check (Same.near 1e-15) what expected (Shape.depth shape point)
  in
  check "to the wall" 0.25 cylinder (v 0.75 1. 5.);
  check "to an end" 0.1 cylinder (v 0. 0.1 5.);
  check "outside" (-1.) cylinder (v 2. 1. 5.);
  check "of a cone, at right angles to the wall"
    (1. /. sqrt 5.)
    cone (v 0. 1. 5.)

let test_told () =
  Expect.prints "cylinder" "cylinder from (0, 0, 5) to (0, 2, 5) radius 1"
    Shape.pp cylinder;
  Expect.prints "cone" "cone from (0, 0, 5) radius 1 to (0, 2, 5) radius 0"
    Shape.pp cone;
  Alcotest.(check (list (option string)))
    "ends"
    [ None; Some "first end"; Some "second end" ]
    (List.init 3 (Shape.part cone));
  Alcotest.(check bool)
    "the other way round it is in the same place" true
    (Shape.place cylinder
    = Shape.place (Shape.cylinder (v 0. 2. 5.) (v 0. 0. 5.) ~radius:1.))

let test_invalid () =
  let o = v 0. 0. 0. and up = v 0. 1. 0. in
  Expect.invalid "no radius" (fun () -> Shape.cylinder o up ~radius:0.);
  Expect.invalid "no length" (fun () -> Shape.cylinder o o ~radius:1.);
  Expect.invalid "NaN" (fun () -> Shape.cylinder o (v 0. nan 0.) ~radius:1.);
  Expect.invalid "two tips" (fun () -> Shape.cone o 0. up 0.);
  Expect.invalid "negative" (fun () -> Shape.cone o 1. up (-1.));
  Expect.invalid "a cone of no length" (fun () -> Shape.cone o 1. o 2.)

let suite =
  ( "Frustum",
    [
      Alcotest.test_case "cylinder" `Quick test_cylinder;
      Alcotest.test_case "edges" `Quick test_cylinder_edges;
      Alcotest.test_case "cone" `Quick test_cone;
      Alcotest.test_case "without a tip" `Quick test_frustum;
      Alcotest.test_case "settle" `Quick test_settle;
      Alcotest.test_case "any size" `Quick test_size;
      Alcotest.test_case "depth" `Quick test_depth;
      Alcotest.test_case "told" `Quick test_told;
      Alcotest.test_case "invalid" `Quick test_invalid;
    ] )
