(* What sentences say of lamps. The only pixel looks along the z axis, from
   (0, 0, -1), at a wall at (0, 0, 4). *)

open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Raylab_explanation
open Test_support
open Build

let reason ?ambient ~lights objects =
  let scene = Scene.make ?ambient ~lights ~objects ~files (camera ()) in
  let e = Explain.centre (Explain.pixel (Prepared.make scene) ~x:0 ~y:0) in
  (Reason.of_ray Film.default e, Reason.sees Film.default e)

let check what expected ?ambient ~lights objects =
  Alcotest.(check string) what expected (fst (reason ?ambient ~lights objects))

(* As samples are grouped. *)
let check_alike what expected ?ambient ~lights objects =
  Alcotest.(check string) what expected (snd (reason ?ambient ~lights objects))

let red = Surface.diffusive Color.red
let wall surface = plane (v 0. 0. 4.) (v 0. 0. 1.) surface
let dim = rgb 0.1 0.1 0.1

(* At (0, 3, 0), 5 away, aiming at a point of the wall [y] below or above. *)
let spot ?(inner = 10.) ?(outer = 20.) y =
  Light.spot ~intensity:9. ~color:Color.white
    (Beam.make_exn ~position:(v 0. 3. 0.) ~target:(v 0. y 4.) ~inner ~outer)

(* A square of side 2, far before the wall, with four points. *)
let area =
  Light.unfading
    (Light.area ~intensity:0.5 ~color:Color.white
       (Pane.make ~corner:(v (-1.) (-1.) (-9996.)) ~edge:(v 2. 0. 0.)
          ~other:(v 0. 2. 0.) ~count:2))

let screen x =
  Object.make
    (Shape.quad ~corner:(v x (-5.) (-5000.)) ~edge:(v 5. 0. 0.)
       ~other:(v 0. 10. 0.))
    red

let test_spot () =
  let plane = "a red plane (object 1), " in
  check "in it" (plane ^ "lit by light 1") ~lights:[ spot 0. ] [ wall red ];
  (* from (0, -3, 4) to (0, -3 + 4 tan a, 4) with cos a = 0.8: y = 0 is straight,
     and (0, 3, 4) is atan 3/4 = 36.87 degrees away *)
  check "outside"
    (plane
   ^ "outside of the cone of light 1, 36.9 degrees from its axis, so that no \
      light reaches it")
    ~lights:[ spot 3. ]
    [ wall red ];
  check "at its edge"
    (plane
   ^ "lit by light 1, at the edge of the cone of light 1, 36.9 degrees from \
      its axis")
    ~lights:[ spot ~outer:50. 3. ]
    [ wall red ];
  check_alike "alike"
    "the red plane (object 1), outside of the cones of lights 1 and 2, so \
     that no light reaches it"
    ~lights:[ spot 3.; spot 3. ]
    [ wall red ]

let test_area () =
  let plane = "a red plane (object 1), " in
  check "all of it" (plane ^ "lit by light 1") ~lights:[ area ] [ wall red ];
  check "half of it"
    (plane ^ "lit by 2 of 4 points of light 1, while quad 2 hides the others")
    ~lights:[ area ]
    [ wall red; screen 0. ];
  check_alike "alike"
    "the red plane (object 1), lit by a part of light 1, while quad 2 hides \
     the others"
    ~lights:[ area ]
    [ wall red; screen 0. ];
  check "nothing of it"
    (plane
   ^ "in the shadow of quad 2 from light 1, so that no light reaches it")
    ~lights:[ area ]
    [ wall red; screen (-2.) ];
  check "by two"
    (plane
   ^ "in the shadow of quad 2 from light 1 and the shadow of quad 3 from \
      light 1, so that no light reaches it")
    ~lights:[ area ]
    [ wall red; screen 0.; screen (-5.) ]

let test_ambient () =
  let plane = "a red plane (object 1), " in
  check "alone"
    (plane ^ "lit by ambient light")
    ~ambient:dim ~lights:[]
    [ wall red ];
  check "with a light"
    (plane ^ "lit by light 1 and by ambient light")
    ~ambient:dim
    ~lights:[ spot ~inner:20. 0. ]
    [ wall red ];
  check "in a shadow"
    (plane
   ^ "outside of the cone of light 1, 36.9 degrees from its axis, so that \
      only ambient light reaches it")
    ~ambient:dim
    ~lights:[ spot 3. ]
    [ wall red ];
  check "on blue"
    (plane ^ "lit by ambient light, but returns nothing of its colour")
    ~ambient:(rgb 0. 0. 1.) ~lights:[]
    [ wall red ]

let test_highlights () =
  let sun x y z =
    Light.directional ~intensity:0.4 ~color:Color.white ~direction:(v x y z)
  and glossy = Surface.glossy ~sharpness:40. Color.white in
  let paint = Surface.mixed [ (1., red); (1., glossy) ] in
  let seen lights surface = fst (reason ~lights [ wall surface ]) in
  let contains what part text = Expect.contains what ~part text in
  contains "in it" "lit by light 1, in the highlight of light 1"
    (seen [ sun 0. 0. 1. ] paint);
  contains "of one of them"
    "lit by lights 1 and 2, in the highlight of light 2"
    (seen [ sun 0. (-1.) 1.; sun 0. 0. 1. ] paint);
  contains "nothing but highlights" ", in the highlight of light 1"
    (seen [ sun 0. 0. 1. ] glossy);
  contains "beside it" ", outside of the highlight of light 1"
    (seen [ sun 0. (-1.) 1. ] glossy)

let suite =
  ( "Illumination",
    [
      Alcotest.test_case "spot" `Quick test_spot;
      Alcotest.test_case "area light" `Quick test_area;
      Alcotest.test_case "ambient light" `Quick test_ambient;
      Alcotest.test_case "highlights" `Quick test_highlights;
    ] )
