open Raylab_scene
open Raylab_tracer
open Raylab_explanation
open Test_support
open Build

(* The only pixel looks along the z axis, from (0, 0, -1). *)
let check what expected ?background ?ray_depth ?(lights = []) objects =
  let scene =
    Scene.make ?background ?ray_depth ~lights ~objects ~files (camera ())
  in
  let e = Explain.centre (Explain.pixel (Prepared.make scene) ~x:0 ~y:0) in
  Alcotest.(check string) what expected (Reason.of_ray Film.default e)

let sun ?(color = Color.white) ?(intensity = 1.) x y z =
  Light.directional ~intensity ~color ~direction:(v x y z)

let bulb ?(intensity = 1.) x y z =
  Light.spherical ~intensity ~color:Color.white ~position:(v x y z)

let red = Surface.diffusive Color.red
let wall ?line surface = plane ?line (v 0. 0. 4.) (v 0. 0. 1.) surface
let behind surface = plane (v 0. 0. (-6.)) (v 0. 0. 1.) surface
let ball ?line surface = sphere ?line (v 0. 0. 4.) 1. surface

let test_background () =
  check "a miss" "the black background, since the ray hits nothing" [];
  check "no ray"
    "the blue background, because raydepth is 0 and no ray is followed"
    ~background:Color.blue ~ray_depth:0
    [ wall red ];
  check "in a mirror" "a mirror (sphere 1) that shows the green background"
    ~background:Color.green
    [ ball Surface.reflective ]

let test_lit () =
  check "one light" "a red plane (object 1, line 7), lit by light 1"
    ~lights:[ sun 0. 0. 1. ]
    [ wall ~line:7 red ];
  check "several"
    "a red sphere (object 1), lit by lights 1, 2 and 3; over-exposed: red 3, \
     shown as 255"
    ~lights:[ sun 0. 0. 1.; sun 0. 0. 1.; sun 0. 0. 1. ]
    [ ball red ]

let test_no_light () =
  check "none there" "a red sphere (object 1), with no light in the scene"
    [ ball red ];
  check "facing away"
    "a red sphere (object 1), facing away from light 1, so that no light \
     reaches it"
    ~lights:[ sun 0. 0. (-1.) ]
    [ ball red ];
  check "behind a plane"
    "a red plane (object 1), with lights 1 and 2 behind it, so that no light \
     reaches it"
    ~lights:[ sun 0. 0. (-1.); bulb 0. 0. 9. ]
    [ wall red ];
  check "along a plane"
    "a red plane (object 1), with light 2 behind it, edge-on to light 1, so \
     that no light reaches it"
    ~lights:[ sun 0. 1. 0.; bulb 0. 0. 9. ]
    [ wall red ];
  check "blocked"
    "a red sphere (object 1), in the shadow of sphere 2 (line 9) from light \
     1, so that no light reaches it"
    ~lights:[ bulb 0. 8. (-5.) ]
    [ ball red; sphere ~line:9 (v 0. 4. (-1.)) 1. red ];
  check "blocked by several"
    "a red plane (object 1), in the shadow of plane 2 from lights 1 and 3 and \
     the shadow of sphere 3 from light 2, so that no light reaches it"
    ~lights:[ sun 0. 0. 1.; bulb 0. 4. 0.; sun 0. 0. 2. ]
    [ wall red; behind red; sphere (v 0. 2. 2.) 0.5 red ];
  check "in its own shadow"
    "a red sphere (object 1), in its own shadow from light 1, so that no \
     light reaches it"
    ~lights:[ sun 0. 0. 1. ]
    [ sphere (v 0. 0. 0.) 4. red ]

let test_dark () =
  check "too weak"
    "a red sphere (object 1), lit by light 1, but too weakly to be seen"
    ~lights:[ bulb ~intensity:1e-3 0. 0. 0. ]
    [ ball red ];
  check "the wrong colour"
    "a red sphere (object 1), lit by light 1, but returns nothing of its \
     colour"
    ~lights:[ sun ~color:Color.cyan 0. 0. 1. ]
    [ ball red ];
  check "a light without light"
    "a red sphere (object 1), lit by light 1, which gives no light"
    ~lights:[ sun ~intensity:0. 0. 0. 1. ]
    [ ball red ];
  check "black" "a black sphere (object 1), which returns no light"
    ~lights:[ sun 0. 0. 1. ]
    [ ball (Surface.diffusive Color.black) ];
  check "what does not shine"
    "a black plane (object 1), which returns no light"
    ~lights:[ sun 0. 0. 1. ]
    [ wall (Surface.luminous Color.black) ]

let test_mirrors () =
  check "one that shows a wall"
    "a mirror (plane 1) that shows the red plane (object 2), lit by light 1"
    ~lights:[ bulb 0. 2. 0. ]
    [ wall Surface.reflective; behind red ];
  check "the chain of one ray"
    "an 80 % mirror (plane 1) that shows the black background, because the \
     chain of 1 ray has ended"
    ~ray_depth:1
    [ wall (Surface.mixed [ (0.8, Surface.reflective) ]) ];
  check "the chain of two rays"
    "a mirror (plane 1) that shows the mirror (plane 2) that shows the blue \
     background, because the chain of 2 rays has ended"
    ~background:Color.blue ~ray_depth:2
    [ wall Surface.reflective; behind Surface.reflective ];
  check "a long chain"
    "a mirror (plane 1) that shows, by way of 8 more mirrors, the black \
     background, because the chain of 9 rays has ended"
    ~ray_depth:9
    [ wall Surface.reflective; behind Surface.reflective ]

let test_mixes () =
  let mix part = Surface.mixed [ (0.7, part); (0.3, Surface.reflective) ] in
  check "paint and mirror"
    "a mix of 70 % red and 30 % mirror (plane 1), lit by light 1, whose \
     mirror shows the black background"
    ~lights:[ sun 0. 0. 1. ]
    [ wall (mix red) ];
  check "glow and mirror"
    "a mix of 30 % mirror and a dark magenta glow (plane 1), whose mirror \
     shows the red plane (object 2), with no light in the scene"
    [ wall (mix (Surface.luminous (rgb 0.6 0. 0.6))); behind red ]

(* The light is exactly where its shadow ray would start. *)
let test_touching () =
  let start = 4. -. 1e-5 in
  check "on the surface"
    "a red plane (object 1), lit by light 1; over-exposed: red 1e+10, shown \
     as 255"
    ~lights:[ bulb 0. 0. start ]
    [ wall red ];
  check "many lights"
    "a red plane (object 1), lit by lights 1, 2, 3, 4, 5 and 2 more; \
     over-exposed: red 7, shown as 255"
    ~lights:(List.init 7 (fun _ -> sun 0. 0. 1.))
    [ wall red ]

let test_subject () =
  let scene = Scene.make ~background:(rgb 0.5 0.25 3.) (camera ()) in
  let pixel = Explain.pixel (Prepared.make scene) ~x:0 ~y:0 in
  let reason =
    "the purple background, since the ray hits nothing; over-exposed: blue 3, \
     shown as 255"
  in
  Alcotest.(check string)
    "of a pixel"
    ("pixel (0, 0) is rgb 128 64 255: " ^ reason)
    (Summary.of_pixel pixel);
  Alcotest.(check string)
    "of a ray"
    ("the ray is rgb 128 64 255: " ^ reason)
    (Summary.to_string (Explain.centre pixel))

let suite =
  ( "Summary",
    [
      Alcotest.test_case "background" `Quick test_background;
      Alcotest.test_case "lit" `Quick test_lit;
      Alcotest.test_case "no light" `Quick test_no_light;
      Alcotest.test_case "dark" `Quick test_dark;
      Alcotest.test_case "mirrors" `Quick test_mirrors;
      Alcotest.test_case "mixes" `Quick test_mixes;
      Alcotest.test_case "lights at odd places" `Quick test_touching;
      Alcotest.test_case "subject" `Quick test_subject;
    ] )
