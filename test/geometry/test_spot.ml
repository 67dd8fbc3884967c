open Raylab_geometry
open Test_support
open Build

let check_number = Alcotest.check Same.number
let check_direction = Alcotest.check (Same.direction_near 1e-15)

(* Which way the normal (0, 1, 0) is turned by a ray along [d]. *)
let test_turn_to () =
  let check what ~side expected d =
    let spot =
      Spot.of_point ~point:Vec3.zero ~normal:(dir 0. 1. 0.) ~offset:0.
    in
    Spot.turn_to spot (Ray.to_raw (ray Vec3.zero d));
    check_direction what expected (Spot.normal spot);
    check_number (what ^ ", side") side spot.side
  and up = dir 0. 1. 0.
  and down = dir 0. (-1.) 0. in
  check "from outside" ~side:1. up (v 1. (-1.) 0.);
  check "from inside" ~side:(-1.) down (v 1. 1. 0.);
  check "at right angles" ~side:1. up (v 1. 0. 0.);
  check "nearly" ~side:(-1.) down (v 1. 1e-300 0.)

(* The side is of the outward normal, so it is told anew for each ray. *)
let test_turn_anew () =
  let floor = Shape.plane ~point:Vec3.zero ~normal:(v 0. 1. 0.) in
  let ray = Ray.to_raw (ray (v 0. (-2.) 0.) (v 0. 1. 0.)) in
  ray.reach <- 2.;
  let spot = Spot.create () in
  for _ = 1 to 2 do
    Shape.settle floor ~part:0 ray spot;
    Spot.turn_to spot ray;
    check_number "from below" (-1.) spot.side;
    check_direction "downwards" (dir 0. (-1.) 0.) (Spot.normal spot)
  done

(* (1, 2, 3) + 5 (0.6, 0.8, 0). *)
let spot =
  Spot.of_point ~point:(v 1. 2. 3.) ~normal:(dir 0.6 0.8 0.) ~offset:5.

let test_start () =
  let raw = Ray.to_raw (ray Vec3.zero (v 0. 0. 1.)) in
  raw.reach <- 7.;
  Spot.start spot raw;
  let started = Ray.of_raw raw in
  Alcotest.check (Same.vec3_near 1e-15) "off the surface" (v 4. 6. 3.)
    (Ray.origin started);
  check_direction "the direction stays" (dir 0. 0. 1.) (Ray.direction started);
  check_number "the reach stays" 7. (Ray.reach started)

(* Along (-1, 0, 0), d . n is -0.6, so d + 1.2 n is (-0.28, 0.96, 0). *)
let test_reflect () =
  let check what spot =
    let raw = Ray.to_raw (ray (v 9. 9. 9.) (v (-1.) 0. 0.)) in
    raw.reach <- 7.;
    Spot.reflect spot raw;
    Alcotest.check (Same.ray_near 1e-14) what
      (ray (Vec3.add (v 1. 2. 3.) (v 3. 4. 0.)) (v (-0.28) 0.96 0.))
      (Ray.of_raw raw)
  in
  check "mirrored" spot;
  (* the same place, off on the same side, the normal to the other *)
  check "the normal's side makes no difference"
    (Spot.of_point ~point:(v 1. 2. 3.) ~normal:(dir (-0.6) (-0.8) 0.)
       ~offset:(-5.))

let test_values () =
  Alcotest.check Same.vec3 "point" (v 1. 2. 3.) (Spot.point spot);
  Alcotest.check Same.vec3 "own" (v 1. 2. 3.) (Spot.own spot);
  check_direction "normal" (dir 0.6 0.8 0.) (Spot.normal spot);
  check_number "size" 0. spot.size;
  check_number "side" 1. spot.side;
  check_number "offset" 5. spot.offset

(* Rounding does not add up: after a hundred thousand mirrors, each turned a
   little otherwise, the direction still has length 1. *)
let test_long_chain () =
  let raw = Ray.to_raw (ray Vec3.zero (v 1. 2. 3.)) in
  for k = 1 to 100_000 do
    let a = float_of_int k in
    let normal = dir (cos a) (sin a) (cos (3. *. a)) in
    Spot.reflect (Spot.of_point ~point:Vec3.zero ~normal ~offset:0.) raw
  done;
  Alcotest.check (Same.near 1e-15) "length 1" 1.
    (Vec3.length (v raw.dx raw.dy raw.dz))

let suite =
  ( "Spot",
    [
      Alcotest.test_case "turn_to" `Quick test_turn_to;
      Alcotest.test_case "turn_to, each ray anew" `Quick test_turn_anew;
      Alcotest.test_case "start" `Quick test_start;
      Alcotest.test_case "reflect" `Quick test_reflect;
      Alcotest.test_case "a long chain" `Quick test_long_chain;
      Alcotest.test_case "values" `Quick test_values;
    ] )
