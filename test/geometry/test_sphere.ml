open Raylab_geometry
open Test_support
open Build

let sphere x y z radius = Sphere.make ~centre:(v x y z) ~radius
let check_all = Alcotest.(check (list (Same.near 1e-14)))
let check_nearest = Alcotest.check (Same.near 1e-14)
let z_axis = ray Vec3.zero (v 0. 0. 1.)

(* The unit sphere around (0, 0, 5) spans z from 4 to 6. *)
let test_ahead () =
  let s = sphere 0. 0. 5. 1. in
  check_all "both" [ 4.; 6. ] (Sphere.intersections s z_axis);
  check_nearest "the nearer" 4. (Sphere.nearest s z_axis)

(* Half a chord at distance 3 from the centre of radius 5 is 4. *)
let test_off_centre () =
  let s = sphere 3. 0. 10. 5. in
  check_all "both" [ 6.; 14. ] (Sphere.intersections s z_axis)

let test_inside () =
  let s = sphere 0. 0. 1. 3. in
  check_all "one behind" [ -2.; 4. ] (Sphere.intersections s z_axis);
  check_nearest "ahead" 4. (Sphere.nearest s z_axis)

let test_behind () =
  let s = sphere 0. 0. (-5.) 1. in
  check_all "both negative" [ -6.; -4. ] (Sphere.intersections s z_axis);
  check_nearest "none" infinity (Sphere.nearest s z_axis)

let test_tangent () =
  let s = sphere 1. 0. 5. 1. in
  check_all "twice the same" [ 5.; 5. ] (Sphere.intersections s z_axis);
  check_nearest "counts" 5. (Sphere.nearest s z_axis)

let test_miss () =
  let s = sphere 1.0001 0. 5. 1. in
  check_all "none" [] (Sphere.intersections s z_axis);
  check_nearest "none" infinity (Sphere.nearest s z_axis)

(* A ray that starts on the sphere: t = 0 does not count. *)
let test_on_it () =
  let s = sphere 0. 0. 2. 2. in
  check_all "0 and 4" [ 0.; 4. ] (Sphere.intersections s z_axis);
  check_nearest "inwards" 4. (Sphere.nearest s z_axis);
  check_nearest "outwards" infinity
    (Sphere.nearest s (ray Vec3.zero (v 0. 0. (-1.))))

let test_normal () =
  let check = Alcotest.check (Same.direction_near 1e-15) in
  let s = sphere 1. 2. 3. 2. in
  check "to the left" (dir (-1.) 0. 0.) (Sphere.normal s (v (-1.) 2. 3.));
  (* (1, 2, 3) + 2 (0.6, 0, 0.8) *)
  check "oblique" (dir 0.6 0. 0.8) (Sphere.normal s (v 2.2 2. 4.6));
  check "the centre" (dir 0. 1. 0.) (Sphere.normal s (v 1. 2. 3.));
  Alcotest.check (Same.vec3_near 1e-15) "project" (v 2.2 2. 4.6)
    (Sphere.project s (dir 0.6 0. 0.8));
  Alcotest.check Same.vec3 "centre" (v 1. 2. 3.) (Sphere.centre s)

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
      Alcotest.test_case "normal and project" `Quick test_normal;
      Alcotest.test_case "invalid" `Quick test_invalid;
    ] )
