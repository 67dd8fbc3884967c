open Raylab_geometry
open Test_support
open Build

let sphere x y z radius = Shape.sphere ~centre:(v x y z) ~radius
let check_all = Alcotest.(check (list (Same.near 1e-14)))
let check_nearest = Alcotest.check (Same.near 1e-14)
let z_axis = ray Vec3.zero (v 0. 0. 1.)

(* The unit sphere around (0, 0, 5) spans z from 4 to 6. *)
let test_ahead () =
  let s = sphere 0. 0. 5. 1. in
  check_all "both" [ 4.; 6. ] (Shape.intersections s z_axis);
  check_nearest "the nearer" 4. (Ask.distance s z_axis)

(* Half a chord at distance 3 from the centre of radius 5 is 4. *)
let test_off_centre () =
  let s = sphere 3. 0. 10. 5. in
  check_all "both" [ 6.; 14. ] (Shape.intersections s z_axis)

let test_inside () =
  let s = sphere 0. 0. 1. 3. in
  check_all "one behind" [ -2.; 4. ] (Shape.intersections s z_axis);
  check_nearest "ahead" 4. (Ask.distance s z_axis)

let test_behind () =
  let s = sphere 0. 0. (-5.) 1. in
  check_all "both negative" [ -6.; -4. ] (Shape.intersections s z_axis);
  check_nearest "none" infinity (Ask.distance s z_axis)

let test_tangent () =
  let s = sphere 1. 0. 5. 1. in
  check_all "twice the same" [ 5.; 5. ] (Shape.intersections s z_axis);
  check_nearest "counts" 5. (Ask.distance s z_axis)

let test_miss () =
  let s = sphere 1.0001 0. 5. 1. in
  check_all "none" [] (Shape.intersections s z_axis);
  check_nearest "none" infinity (Ask.distance s z_axis)

(* A ray that starts on the sphere: t = 0 does not count. *)
let test_on_it () =
  let s = sphere 0. 0. 2. 2. in
  check_all "0 and 4" [ 0.; 4. ] (Shape.intersections s z_axis);
  check_nearest "inwards" 4. (Ask.distance s z_axis);
  check_nearest "outwards" infinity
    (Ask.distance s (ray Vec3.zero (v 0. 0. (-1.))))

let test_normal () =
  let check = Alcotest.check (Same.direction_near 1e-15) in
  let s = sphere 1. 2. 3. 2. in
  check "to the left" (dir (-1.) 0. 0.) (Shape.normal s (v (-1.) 2. 3.));
  (* (1, 2, 3) + 2 (0.6, 0, 0.8) *)
  check "oblique" (dir 0.6 0. 0.8) (Shape.normal s (v 2.2 2. 4.6))

(* Rays from the centre that end before the sphere, on it and beyond it. *)
let test_settle () =
  let s = sphere 1. 2. 3. 2. and centre = v 1. 2. 3. in
  let check_point = Alcotest.check (Same.vec3_near 1e-15) in
  List.iter
    (fun reach ->
      let spot = Ask.spot s ~reach (ray centre (v 3. 0. 4.)) in
      check_point "brought to the sphere" (v 2.2 2. 4.6) (Spot.point spot);
      check_point "its own point" (v 2.2 2. 4.6) (Spot.own spot);
      Alcotest.check
        (Same.direction_near 1e-15)
        "outward" (dir 0.6 0. 0.8) (Spot.normal spot);
      Alcotest.check Same.number "the radius" 2. spot.size)
    [ 1.; 2.; 5. ];
  let spot = Ask.spot s ~reach:0. (ray centre (v 3. 0. 4.)) in
  check_point "at the centre" centre (Spot.point spot);
  Alcotest.check
    (Same.direction_near 1e-15)
    "along the ray" (dir 0.6 0. 0.8) (Spot.normal spot)

let test_crossings () =
  let check what expected s =
    Alcotest.(check (list (triple (Same.near 1e-14) int bool)))
      what expected (Ask.crossings s z_axis)
  in
  check "in and out" [ (4., 0, true); (6., 0, false) ] (sphere 0. 0. 5. 1.);
  check "also behind" [ (-2., 0, true); (4., 0, false) ] (sphere 0. 0. 1. 3.);
  check "touched" [ (5., 0, true); (5., 0, false) ] (sphere 1. 0. 5. 1.);
  check "missed" [] (sphere 1.0001 0. 5. 1.)

let test_box () =
  let { Box3.low; high } =
    Sphere.box (Sphere.make ~centre:(v 1. 2. 3.) ~radius:2.)
  in
  Alcotest.check Same.vec3 "low" (v (-1.) 0. 1.) low;
  Alcotest.check Same.vec3 "high" (v 3. 4. 5.) high;
  Alcotest.check Same.vec3 "centre" (v 1. 2. 3.)
    (Sphere.centre (Sphere.make ~centre:(v 1. 2. 3.) ~radius:2.))

let test_invalid () =
  List.iter
    (fun radius ->
      Expect.invalid (Printf.sprintf "radius %g" radius) (fun () ->
          sphere 0. 0. 0. radius))
    [ 0.; -0.; -1.; nan; infinity ];
  List.iter
    (fun bad ->
      Expect.invalid "x" (fun () -> sphere bad 0. 0. 1.);
      Expect.invalid "y" (fun () -> sphere 0. bad 0. 1.);
      Expect.invalid "z" (fun () -> sphere 0. 0. bad 1.))
    [ nan; infinity; neg_infinity ]

let suite =
  ( "Sphere",
    [
      Alcotest.test_case "ahead" `Quick test_ahead;
      Alcotest.test_case "off centre" `Quick test_off_centre;
      Alcotest.test_case "from inside" `Quick test_inside;
      Alcotest.test_case "behind" `Quick test_behind;
      Alcotest.test_case "tangent" `Quick test_tangent;
      Alcotest.test_case "miss" `Quick test_miss;
      Alcotest.test_case "from a point of it" `Quick test_on_it;
      Alcotest.test_case "normal" `Quick test_normal;
      Alcotest.test_case "settle" `Quick test_settle;
      Alcotest.test_case "crossings" `Quick test_crossings;
      Alcotest.test_case "box" `Quick test_box;
      Alcotest.test_case "invalid" `Quick test_invalid;
    ] )
