(* The ray from (0, 0, -1) along the z axis, mirrored. *)

open Raylab_scene
open Test_support
open Build

let check = Alcotest.check (Same.color_near 1e-12)
let background = rgb 0.2 0.4 0.6
let mirror = Surface.reflective
let part k = Surface.mixed [ (k, mirror) ]
let glow = Surface.luminous (rgb 8. 4. 0.)
let facing surface = plane (v 0. 0. 4.) (v 0. 0. 1.) surface
let behind surface = plane (v 0. 0. (-6.)) (v 0. 0. 1.) surface
let color ?ray_depth objects = Shot.centre ~background ?ray_depth objects

let test_one () =
  check "sees behind the eye" (rgb 8. 4. 0.)
    (color [ facing mirror; behind glow ]);
  check "in part" (rgb 2. 1. 0.) (color [ facing (part 0.25); behind glow ]);
  check "weights above 1" (rgb 16. 8. 0.)
    (color [ facing (part 2.); behind glow ]);
  check "the background" background (color [ facing mirror ]);
  check "a sphere's too" (rgb 8. 4. 0.)
    (color [ sphere (v 0. 0. 5.) 1. mirror; behind glow ])

(* A periscope: at (0, 0, 4) the plane y = z - 4 turns the ray upwards, at
   (0, 6, 4) the plane y = z + 2 turns it back along z, to (0, 6, 8). Each
   mirror halves it. The chain has three rays. *)
let periscope =
  [
    plane (v 0. 0. 4.) (v 0. 1. (-1.)) (part 0.5);
    plane (v 0. 6. 4.) (v 0. (-1.) 1.) (part 0.5);
    plane (v 0. 0. 8.) (v 0. 0. 1.) glow;
  ]

let test_two () = check "halved twice" (rgb 2. 1. 0.) (color periscope)

(* Where no ray is left the background stands in. *)
let test_ends () =
  check "three rays" (rgb 2. 1. 0.) (color ~ray_depth:3 periscope);
  check "two: a quarter of it" (rgb 0.05 0.1 0.15)
    (color ~ray_depth:2 periscope);
  check "one: half of it" (rgb 0.1 0.2 0.3) (color ~ray_depth:1 periscope);
  check "none: all of it" background (color ~ray_depth:0 periscope);
  check "none, before a light" background (color ~ray_depth:0 [ facing glow ])

(* Two mirrors that face each other, each adding 1 of red: with n rays it is
   n times red and the background at the end. *)
let test_endless () =
  let both =
    Surface.mixed [ (1., mirror); (1., Surface.luminous Color.red) ]
  in
  let between = [ facing both; behind both ] in
  check "four rays, as usual" (rgb 4.2 0.4 0.6) (color between);
  check "a thousand" (rgb 1000.2 0.4 0.6) (color ~ray_depth:1000 between)

(* A long chain must fit on the stack. That of JavaScript is small. *)
let test_long () =
  let between ray_depth = color ~ray_depth [ facing mirror; behind mirror ] in
  check "a few hundred rays" background (between 400);
  let hundred_thousand () = between 100_000 in
  if Javascript.here then
    Alcotest.check_raises "too long"
      (Raylab_tracer.Chain.Too_long { ray_depth = 100_000 })
      (fun () -> ignore (hundred_thousand () : Color.t))
  else check "a hundred thousand rays" background (hundred_thousand ())

(* What it emits, 0.5 red; albedo 2 * 3 * 0.5 = 3 times light of 0.1; mirror
   2 * 0.25 = 0.5 of the background. *)
let test_nested_mix () =
  let surface =
    Surface.mixed
      [
        (0.5, Surface.luminous Color.red);
        ( 2.,
          Surface.mixed
            [
              (0.25, mirror);
              (3., Surface.mixed [ (0.5, Surface.diffusive Color.white) ]);
            ] );
      ]
  in
  check "(0.5 + 0.3 + 0.1, 0.3 + 0.2, 0.3 + 0.3)" (rgb 0.9 0.5 0.6)
    (Shot.centre ~background
       ~lights:[ Shot.sun ~intensity:0.1 0. 0. 1. ]
       [ facing surface ])

(* 45 degrees on the side of a sphere: hit at (0, 0, 4) with the normal
   (0, 1, -1) / sqrt 2, the ray turns upwards, to the ceiling at 9. *)
let test_sphere () =
  let r = 3. in
  let centre = v 0. (-.r /. sqrt 2.) (4. +. (r /. sqrt 2.)) in
  check "upwards" (rgb 8. 4. 0.)
    (color [ sphere centre r mirror; plane (v 0. 9. 0.) (v 0. 1. 0.) glow ])

let suite =
  ( "Mirrors",
    [
      Alcotest.test_case "one" `Quick test_one;
      Alcotest.test_case "two" `Quick test_two;
      Alcotest.test_case "the end of a chain" `Quick test_ends;
      Alcotest.test_case "facing mirrors" `Quick test_endless;
      Alcotest.test_case "a long chain" `Quick test_long;
      Alcotest.test_case "a nested mix" `Quick test_nested_mix;
      Alcotest.test_case "a sphere" `Quick test_sphere;
    ] )
