(* Where shapes, lights and the eye meet. The ray starts at (0, 0, -1) along
   the z axis. *)

open Raylab_scene
open Raylab_tracer
open Test_support
open Build

let check = Alcotest.check (Same.color_near 1e-9)
let white = Surface.diffusive Color.white
let red = Surface.luminous Color.red
let green = Surface.luminous Color.green
let background = rgb 0.1 0.2 0.3
let wall surface = plane (v 0. 0. 4.) (v 0. 0. 1.) surface

(* The sphere of radius 5 around the eye, lit from the eye: 25 / 25 head on,
   whatever the pixel. *)
let test_inside () =
  let scene light =
    Prepared.make
      (Scene.make
         (camera ~width:5 ~height:5 ())
         ~background ~lights:[ light ]
         ~objects:[ sphere (v 0. 0. (-1.)) 5. white ])
  in
  let at scene x y = Tracer.pixel scene ~x ~y in
  let lit = scene (Shot.bulb ~intensity:25. 0. 0. (-1.)) in
  List.iter
    (fun (x, y) -> check "lit from inside" Color.white (at lit x y))
    [ (0, 0); (2, 2); (4, 1) ];
  check "not from outside" Color.black
    (at (scene (Shot.bulb ~intensity:25. 0. 0. 20.)) 2 2);
  check "not by a sun" Color.black (at (scene (Shot.sun 0. 0. 1.)) 2 2)

(* The light is at (0, 4, 0), on the ceiling y = 4. From (0, 0, 4) it is
   sqrt 32 away at the cosine 4 / sqrt 32, so 32 sqrt 2 shines with 1. *)
let test_light_on_surface () =
  let lights = [ Shot.bulb ~intensity:(32. *. sqrt 2.) 0. 4. 0. ] in
  let shot others = Shot.centre ~lights (wall white :: others) in
  check "alone" Color.white (shot []);
  check "on a ceiling" Color.white
    (shot [ plane (v 0. 4. 0.) (v 0. 1. 0.) white ]);
  (* the sphere is above the light *)
  check "under a lamp" Color.white (shot [ sphere (v 0. 5. 0.) 1. white ]);
  check "on the far side of a ball" Color.black
    (shot [ sphere (v 0. 3. 1.) (sqrt 2.) white ])

let test_light_at_the_point () =
  let shot z =
    Shot.centre ~lights:[ Shot.bulb ~intensity:1e-10 0. 0. z ] [ wall white ]
  in
  check "gives nothing" Color.black (shot 4.);
  check "nor behind" Color.black (shot 4.5);
  (* 1e-10 / 0.5^2 *)
  Alcotest.check (Same.color_near 1e-20) "before it does" (grey 4e-10)
    (shot 3.5)

(* A light nearer than the offset must not fall behind its own shadow ray. *)
let test_light_very_near () =
  let shot =
    Shot.centre
      ~lights:[ Shot.bulb ~intensity:1e-12 0. 0. (4. -. 1e-6) ]
      [ wall white ]
  in
  Alcotest.check (Same.color_near 1e-6) "1e-12 / (1e-6)^2" Color.white shot

(* The square of the distance must be a double. *)
let test_light_beyond_squares () =
  let shot intensity z =
    Shot.centre ~lights:[ Shot.bulb ~intensity 0. 0. z ] [ wall white ]
  in
  check "as far as squares reach" Color.white (shot 1e306 (-1e153));
  check "farther" Color.black (shot max_float (-1e154));
  check "very far" Color.black (shot max_float (-1e200));
  check "as far as doubles reach" Color.black (shot max_float (-.max_float));
  let near z =
    Shot.centre
      ~lights:[ Shot.bulb ~intensity:1e-300 0. 0. z ]
      [ plane Raylab_geometry.Vec3.zero (v 0. 0. 1.) white ]
  in
  check "as near as squares reach" Color.white (near (-1e-150));
  check "nearer" Color.black (near (-1e-170))

let test_coincident () =
  check "the first" Color.red (Shot.centre [ wall red; wall green ]);
  check "of the scene" Color.green (Shot.centre [ wall green; wall red ]);
  check "sphere, plane" Color.red
    (Shot.centre [ sphere (v 0. 0. 5.) 1. red; wall green ]);
  check "plane, sphere" Color.green
    (Shot.centre [ wall green; sphere (v 0. 0. 5.) 1. red ]);
  check "opposite normals" Color.red
    (Shot.centre [ wall red; plane (v 0. 0. 4.) (v 0. 0. (-1.)) green ])

let test_parallel () =
  let shot y =
    Shot.centre ~background [ plane (v 0. y 0.) (v 0. 1. 0.) red ]
  in
  check "below" background (shot (-1.));
  check "above" background (shot 1.);
  check "in the plane" background (shot 0.)

let test_tangent () =
  let shot x = Shot.centre ~background [ sphere (v x 0. 5.) 1. red ] in
  check "touched" Color.red (shot 1.);
  check "missed" background (shot (Float.succ 1.))

(* t > 0: what the eye lies on is not seen. *)
let test_eye_on_surface () =
  check "a plane" background
    (Shot.centre ~background [ plane (v 0. 0. (-1.)) (v 0. 0. 1.) red ]);
  check "a sphere behind" background
    (Shot.centre ~background [ sphere (v 0. 0. (-2.)) 1. red ]);
  check "the far side of a sphere ahead" Color.red
    (Shot.centre ~background [ sphere Raylab_geometry.Vec3.zero 1. red ])

let suite =
  ( "Edge cases",
    [
      Alcotest.test_case "eye inside a sphere" `Quick test_inside;
      Alcotest.test_case "light on a surface" `Quick test_light_on_surface;
      Alcotest.test_case "light at the point" `Quick test_light_at_the_point;
      Alcotest.test_case "light very near" `Quick test_light_very_near;
      Alcotest.test_case "light beyond squares" `Quick
        test_light_beyond_squares;
      Alcotest.test_case "coincident surfaces" `Quick test_coincident;
      Alcotest.test_case "parallel to a plane" `Quick test_parallel;
      Alcotest.test_case "tangent to a sphere" `Quick test_tangent;
      Alcotest.test_case "eye on a surface" `Quick test_eye_on_surface;
    ] )
