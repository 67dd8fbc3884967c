open Raylab_scene
open Test_support
open Build

let ball = sphere (v 0. 0. 6.) 1. (Surface.diffusive (rgb 1. 0. 0.))

let bulb =
  Light.spherical ~intensity:5. ~color:(rgb 0. 1. 0.) ~position:(v 0. 5. 0.)

let scene =
  Scene.make ~background:(rgb 0. 0. 1.) ~lights:[ bulb ] ~objects:[ ball ]
    (camera ())

let test_defaults () =
  let bare = Scene.make (camera ()) in
  Alcotest.check Same.background "background"
    (Background.plain Color.black)
    bare.background;
  Alcotest.(check int) "ray depth" 4 bare.ray_depth;
  Alcotest.(check int) "lights" 0 (List.length bare.lights);
  Alcotest.(check int) "objects" 0 (List.length bare.objects)

let test_invalid () =
  List.iter
    (fun ray_depth ->
      Expect.invalid "ray depth" (fun () -> Scene.make ~ray_depth (camera ())))
    [ -1; Scene.max_ray_depth + 1; min_int ];
  Alcotest.(check int)
    "the most" 1_000_000
    (Scene.make ~ray_depth:Scene.max_ray_depth (camera ())).ray_depth;
  List.iter
    (fun bad ->
      Expect.invalid "background" (fun () ->
          Scene.make ~background:(rgb 0. 0. bad) (camera ())))
    [ -1.; nan; infinity ]

(* Each colour here is one of the three primaries, whose luminances are the
   three factors. *)
let test_greyscale () =
  let grey_scene = Scene.greyscale scene in
  let expected =
    Scene.make ~background:(grey 0.0722)
      ~lights:
        [
          Light.spherical ~intensity:5. ~color:(grey 0.7152)
            ~position:(v 0. 5. 0.);
        ]
      ~objects:[ sphere (v 0. 0. 6.) 1. (Surface.diffusive (grey 0.2126)) ]
      (camera ())
  in
  Alcotest.check Same.scene "every colour" expected grey_scene

(* Lines tell where an object stands in a file, not what it is. *)
let test_equal () =
  let copy ?(lights = [ bulb ]) ?(objects = [ ball ]) ?(camera = camera ()) ()
      =
    Scene.make ~background:(rgb 0. 0. 1.) ~lights ~objects camera
  in
  let differs what other =
    Alcotest.(check bool) what false (Scene.equal scene other)
  in
  Alcotest.check Same.scene "the same again" scene (copy ());
  Alcotest.check Same.scene "with other origins" scene
    (copy
       ~objects:
         [ sphere ~line:3 (v 0. 0. 6.) 1. (Surface.diffusive (rgb 1. 0. 0.)) ]
       ());
  differs "no lights" (copy ~lights:[] ());
  differs "one object twice" (copy ~objects:[ ball; ball ] ());
  differs "another camera" (copy ~camera:(camera ~width:2 ()) ())

let test_places () =
  let check what expected scene origin =
    Alcotest.(check (option string))
      what expected
      (Option.map Provenance.to_string (Scene.provenance scene origin))
  in
  let scene = Scene.make ~files (camera ()) in
  check "the main file" (Some "line 7") scene (at_line 7);
  check "another" (Some "line 7 of wood.scene") scene (at_line_of_wood 7);
  check "unknown" None scene Unknown;
  let changed =
    Scene.(scene |> with_ray_depth 1 |> with_objects [] |> greyscale)
  in
  check "of a changed scene" (Some "line 7") changed (at_line 7);
  check "without places" None (Scene.without_places scene) (at_line 7)

(* A scene whose every part is another than the default, so that a part that is
   lost is missed. *)
let test_with () =
  let full ?(camera = camera ()) ?(background = rgb 0. 0. 1.) ?(ray_depth = 7)
      ?(lights = [ bulb ]) ?(objects = [ ball ]) () =
    Scene.make ~background ~ray_depth ~lights ~objects camera
  in
  let check what expected change =
    Alcotest.check Same.scene what expected (change (full ()))
  in
  let wide = camera ~width:2 () in
  check "camera" (full ~camera:wide ()) (Scene.with_camera wide);
  check "background"
    (full ~background:Color.white ())
    (Scene.with_background Color.white);
  check "ray depth" (full ~ray_depth:6 ()) (Scene.with_ray_depth 6);
  check "lights" (full ~lights:[] ()) (Scene.with_lights []);
  check "objects"
    (full ~objects:[ ball; ball ] ())
    (Scene.with_objects [ ball; ball ]);
  Expect.invalid "background" (fun () ->
      Scene.with_background (rgb 0. nan 0.) scene);
  Expect.invalid "ray depth" (fun () -> Scene.with_ray_depth (-1) scene)

let test_pp () =
  let shown = Property.show Scene.pp scene in
  List.iter
    (fun part -> Expect.contains "pp" ~part shown)
    [
      "1 x 1 pixels";
      "light 1: spherical light";
      "object 1: sphere centre (0, 0, 6) radius 1";
      "ray depth 4";
    ];
  let crowd =
    Scene.make ~objects:(List.init 5000 (fun _ -> ball)) (camera ())
  in
  let shown = Property.show Scene.pp crowd in
  Alcotest.(check bool) "not all of many" true (String.length shown < 2000);
  Expect.contains "the rest is counted" ~part:"more objects" shown

let suite =
  ( "Scene",
    [
      Alcotest.test_case "defaults" `Quick test_defaults;
      Alcotest.test_case "invalid" `Quick test_invalid;
      Alcotest.test_case "greyscale" `Quick test_greyscale;
      Alcotest.test_case "equal" `Quick test_equal;
      Alcotest.test_case "with one thing changed" `Quick test_with;
      Alcotest.test_case "places" `Quick test_places;
      Alcotest.test_case "pp" `Quick test_pp;
    ] )
