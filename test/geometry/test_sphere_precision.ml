(* Spheres of sizes at which the textbook's formula loses its digits. *)

open Raylab_geometry
open Test_support
open Build

let sphere x y z radius = Shape.sphere ~centre:(v x y z) ~radius
let relative e x = Same.near (e *. abs_float x)

(* The line passes the centre at distance 0.6, so half the chord is 0.8; from
   1e8 the two distances differ in their last 8 digits only. In b^2 - c both
   are 1e16, whose neighbours are 2 apart: the textbook finds no digit of
   0.64. *)
let test_small_and_far () =
  let s = sphere 0.6 0. 1e8 1. in
  match Shape.intersections s (ray Vec3.zero (v 0. 0. 1.)) with
  | [ near; far ] ->
      Alcotest.check (Same.near 3e-8) "near" (1e8 -. 0.8) near;
      Alcotest.check (Same.near 3e-8) "far" (1e8 +. 0.8) far
  | _ -> Alcotest.fail "not hit"

let test_just_missed_far_away () =
  let hits x =
    Shape.intersections (sphere x 0. 1e8 1.) (ray Vec3.zero (v 0. 0. 1.)) <> []
  in
  Alcotest.(check bool) "inside the edge" true (hits 0.999999);
  Alcotest.(check bool) "outside the edge" false (hits 1.000001)

(* A ground of radius 1e6 whose top is the origin, seen from 1 above. *)
let test_huge () =
  let ground = sphere 0. (-1e6) 0. 1e6 in
  Alcotest.check (Same.near 1e-9) "straight down" 1.
    (Ask.distance ground (ray (v 0. 1. 0.) (v 0. (-1.) 0.)));
  (* along (3, -4, 0) / 5 the Ask.distance t solves t^2 - 2 * 0.8 (R + 1) t +
     (R + 1)^2 - R^2 = 0; with R = 1e6 and b = 800000.8 that is
     (2 R + 1) / (b + sqrt (b^2 - 2 R - 1)), where sqrt is
     b - 1.25000050...: 2000001 / 1600000.35 = 1.2500003... *)
  Alcotest.check (Same.near 1e-5) "obliquely" 1.25
    (Ask.distance ground (ray (v 0. 1. 0.) (v 3. (-4.) 0.)))

(* The same picture at every scale: centre 5 k, radius k. *)
let test_scales () =
  List.iter
    (fun k ->
      let t =
        Ask.distance (sphere 0. 0. (5. *. k) k) (ray Vec3.zero (v 0. 0. 1.))
      in
      Alcotest.check
        (relative 1e-14 (4. *. k))
        (Printf.sprintf "%g" k) (4. *. k) t)
    [ 1e-150; 1e-100; 1e-10; 1.; 1e10; 1e100; 1e150 ]

(* The limit that the documentation states: what cannot be squared is not
   met. *)
let test_squares_overflow () =
  Alcotest.(check (list (float 0.)))
    "from the centre" []
    (Shape.intersections (sphere 0. 0. 0. 1e200) (ray Vec3.zero (v 0. 0. 1.)))

let point_is_on (s : Sphere.t) ray t =
  let point = Ray.at ray t in
  let r = Vec3.length (Vec3.sub point (Sphere.centre s)) in
  (* rounding is relative to the largest number that went in *)
  let size =
    s.radius
    +. Vec3.magnitude (Sphere.centre s)
    +. Vec3.magnitude (Ray.origin ray)
  in
  abs_float (r -. s.radius) <= 1e-7 *. size

let spheres_and_rays number =
  QCheck2.Gen.triple (Generate.vec3 number) (Generate.positive number)
    (Generate.ray number)

let on_it =
  Property.holds "an intersection lies on the sphere" ~count:5000
    (spheres_and_rays Generate.everyday) (fun (centre, radius, ray) ->
      let s = Sphere.make ~centre ~radius in
      List.for_all (point_is_on s ray) (Shape.intersections (Sphere s) ray))

let inside_always_hits =
  Property.holds "from inside every ray hits once" ~count:2000
    (spheres_and_rays Generate.everyday) (fun (origin, radius, ray) ->
      (* the origin is at 0.9 radii from the centre *)
      let away = Vec3.scale (0.9 *. radius) (Ray.direction ray :> Vec3.t) in
      let s = Shape.sphere ~centre:(Vec3.add origin away) ~radius in
      let ray = Ray.make ~origin ~direction:(Ray.direction ray) in
      match Shape.intersections s ray with
      | [ behind; ahead ] -> behind < 0. && ahead > 0.
      | _ -> false)

let finite_and_sorted =
  Property.holds "finite and in order, whatever the size" ~count:5000
    (spheres_and_rays Generate.extreme) (fun (centre, radius, ray) ->
      match Shape.intersections (Shape.sphere ~centre ~radius) ray with
      | [] -> true
      | [ a; b ] -> Float.is_finite a && Float.is_finite b && a <= b
      | _ -> false)

let suite =
  ( "Sphere, precision",
    [
      Alcotest.test_case "small and far" `Quick test_small_and_far;
      Alcotest.test_case "the edge far away" `Quick test_just_missed_far_away;
      Alcotest.test_case "huge" `Quick test_huge;
      Alcotest.test_case "every scale" `Quick test_scales;
      Alcotest.test_case "squares overflow" `Quick test_squares_overflow;
      on_it;
      inside_always_hits;
      finite_and_sorted;
    ] )
