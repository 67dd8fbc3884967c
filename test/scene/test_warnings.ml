open Raylab_scene
open Test_support
open Build

(* [check what parts scene]: one warning for each of [parts], in any order,
   which holds it. *)
let check what parts scene =
  let warnings = Scene.warnings scene in
  Alcotest.(check int)
    (what ^ ": how many") (List.length parts) (List.length warnings);
  List.iter
    (fun part -> Expect.contains what ~part (String.concat "\n" warnings))
    parts

let matt = sphere (v 0. 0. 6.) 1. (Surface.diffusive Color.white)
let mirror = sphere (v 3. 0. 6.) 1. Surface.reflective
let glow = sphere (v 0. 0. 6.) 1. (Surface.luminous Color.white)

let bulb =
  Light.spherical ~intensity:1. ~color:Color.white ~position:(v 0. 5. 0.)

let scene ?ray_depth ?(lights = [ bulb ]) ?(objects = [ matt ])
    ?(camera = camera ()) () =
  Scene.make ?ray_depth ~lights ~objects camera

let test_none () =
  check "all right" [] (scene ());
  check "nothing needs light" []
    (scene ~lights:[] ~objects:[ glow; mirror ] ());
  check "a mirror with a ray to spare" []
    (scene ~ray_depth:2 ~objects:[ mirror ] ())

let test_each () =
  check "no object" [ "no object" ] (scene ~objects:[] ());
  check "no ray" [ "raydepth is 0" ] (scene ~ray_depth:0 ());
  check "no light" [ "no light" ] (scene ~lights:[] ());
  check "a mirror without rays" [ "raydepth is 1" ]
    (scene ~ray_depth:1 ~objects:[ mirror ] ());
  check "two at once"
    [ "no object"; "raydepth is 0" ]
    (scene ~ray_depth:0 ~objects:[] ())

let test_glass () =
  let glass = Surface.glass ~index:1.5 Color.white in
  let ball = sphere (v 0. 0. 6.) 1. glass
  and disc surface =
    Object.make
      (Raylab_geometry.Shape.disc ~centre:(v 0. 0. 4.) ~normal:(v 0. 0. 1.)
         ~radius:1.)
      surface
  and lamp =
    Light.spherical ~intensity:1. ~color:Color.white ~position:(v 0. 0. 6.)
  in
  check "a ball" [] (scene ~ray_depth:8 ~objects:[ ball ] ());
  check "a light in it" []
    (scene ~ray_depth:8 ~lights:[ lamp ] ~objects:[ ball ] ());
  check "short chains" [ "raydepth is 7" ]
    (scene ~ray_depth:7 ~objects:[ ball ] ());
  check "a disc of glass" [ "disc 2 is of glass" ]
    (scene ~ray_depth:8 ~objects:[ ball; disc glass ] ());
  check "in a mix too" [ "disc 1 is of glass" ]
    (scene ~ray_depth:8 ~objects:[ disc (Surface.mixed [ (0.5, glass) ]) ] ());
  check "a filter" []
    (scene ~objects:[ disc (Surface.refractive ~index:1. Color.red) ] ())

(* The canvas of 2 x 2 is square, the picture of 2 x 1 pixels is not: it shows
   everything twice as wide as it is. *)
let test_distortion () =
  check "stretched" [ "2 times as wide" ]
    (scene ~camera:(camera ~width:2 ~height:1 ()) ());
  check "squeezed" [ "2 times as high" ]
    (scene ~camera:(camera ~width:1 ~height:2 ()) ());
  check "hardly" [] (scene ~camera:(camera ~width:1000 ~height:1001 ()) ())

let suite =
  ( "Scene.warnings",
    [
      Alcotest.test_case "none" `Quick test_none;
      Alcotest.test_case "each" `Quick test_each;
      Alcotest.test_case "glass" `Quick test_glass;
      Alcotest.test_case "distortion" `Quick test_distortion;
    ] )
