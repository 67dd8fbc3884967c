open Raylab_geometry
open Raylab_scene
open Test_support
open Build

let color = Color.white
let normal = dir 0. 1. 0.
let check_ray = Alcotest.check (Same.ray_near 1e-14)

(* Against the light's direction, from 0.1 above the point, without end. *)
let test_directional () =
  let sun =
    Light.directional ~intensity:1. ~color ~direction:(v 3. (-4.) 0.)
  in
  check_ray "upwards"
    (ray (v 5. 0.1 0.) (v (-3.) 4. 0.))
    (Option.get (Light.shadow_ray sun ~point:(v 5. 0. 0.) ~normal ~offset:0.1))

(* From (0, 0.1, 0) to (0, 4, 0) it is 3.9; 0.1 of it is left out. *)
let test_point () =
  let bulb = Light.spherical ~intensity:1. ~color ~position:(v 0. 4. 0.) in
  let shadow_ray =
    Option.get (Light.shadow_ray bulb ~point:Vec3.zero ~normal ~offset:0.1)
  in
  Alcotest.check (Same.near 1e-14) "reach" 3.8 (Ray.reach shadow_ray);
  Alcotest.check Same.vec3 "towards the light" (v 0. 1. 0.)
    (Ray.direction shadow_ray :> Vec3.t);
  let check what expected t =
    Alcotest.(check bool) what expected (Light.blocks shadow_ray t)
  in
  check "between" true 2.;
  check "just before its end" true (Float.pred (Ray.reach shadow_ray));
  check "at its end" false (Ray.reach shadow_ray);
  check "behind the light" false 5.;
  check "at the point" false 0.;
  check "before the point" false (-1.);
  check "NaN" false nan;
  check "never" false infinity

let test_endless () =
  let sun =
    Light.directional ~intensity:1. ~color ~direction:(v 0. (-1.) 0.)
  in
  let shadow_ray =
    Option.get (Light.shadow_ray sun ~point:Vec3.zero ~normal ~offset:0.1)
  in
  Alcotest.(check bool) "far away" true (Light.blocks shadow_ray 1e300);
  Alcotest.(check bool) "never" false (Light.blocks shadow_ray infinity)

let test_none () =
  let bulb = Light.spherical ~intensity:1. ~color ~position:(v 0. 0.5 0.) in
  Alcotest.(check bool)
    "the light is where the ray starts" true
    (Light.shadow_ray bulb ~point:Vec3.zero ~normal ~offset:0.5 = None)

let suite =
  ( "Shadow rays",
    [
      Alcotest.test_case "directional" `Quick test_directional;
      Alcotest.test_case "point" `Quick test_point;
      Alcotest.test_case "endless" `Quick test_endless;
      Alcotest.test_case "none" `Quick test_none;
    ] )
