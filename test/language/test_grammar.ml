open Raylab_scene
open Test_support
open Build

let ball = sphere (v 0. 0. 6.) 1. Surface.reflective
let floor = plane (v 0. (-1.) 0.) (v 0. 1. 0.) (Surface.luminous Color.red)

let check what expected text =
  Alcotest.check Same.scene what expected (Read.scene (Read.with_header text))

let objects = [ ball; floor ]
let two_objects = Scene.make ~objects Read.camera

let test_objects () =
  check "one a line" two_objects
    "objects\nsphere 0 0 6 1 reflective\nplane 0 -1 0 0 1 0 luminous red";
  check "two on one line" two_objects
    "objects sphere 0 0 6 1 reflective plane 0 -1 0 0 1 0 luminous red";
  check "one word a line" two_objects
    (String.concat "\n"
       (String.split_on_char ' '
          "objects sphere 0 0 6 1 reflective plane 0 -1 0 0 1 0 luminous red"));
  check "the word left out" two_objects
    "sphere 0 0 6 1 reflective plane 0 -1 0 0 1 0 luminous red";
  check "none" (Scene.make Read.camera) "objects";
  check "nothing" (Scene.make Read.camera) ""

let test_lights () =
  let lights =
    [
      Light.directional ~intensity:0.5 ~color:(rgb 1. 2. 3.)
        ~direction:(v 0. (-2.) 0.);
      Light.spherical ~intensity:7. ~color:Color.cyan ~position:(v 1. 2. 3.);
    ]
  in
  let text = "lights directional .5 1 2 3 0 -2 0 spherical 7 cyan 1 2 3" in
  check "and no objects" (Scene.make ~lights Read.camera) text;
  check "and objects without the word"
    (Scene.make ~lights ~objects:[ ball ] Read.camera)
    (text ^ " sphere 0 0 6 1 reflective");
  check "and objects"
    (Scene.make ~lights ~objects:[ ball ] Read.camera)
    (text ^ " objects sphere 0 0 6 1 reflective");
  check "no lights"
    (Scene.make ~objects:[ ball ] Read.camera)
    "lights objects sphere 0 0 6 1 reflective"

let test_header () =
  let same what text =
    Alcotest.check Same.scene what
      (Scene.make ~background:(rgb 1. 0. 0.) ~ray_depth:7 Read.camera)
      (Read.scene text)
  in
  same "one order"
    "imWidth 4 imHeight 3 canvWidth 8 canvHeight 6 depth 5 bcolor red \
     raydepth 7";
  same "another"
    "raydepth 7 depth 5 bcolor 1 0 0 canvHeight 6 imHeight 3 canvWidth 8 \
     imWidth 4";
  same "its other name"
    "bgcolor red depth 5 raydepth 7 canvHeight 6 imHeight 3 canvWidth 8 \
     imWidth 4";
  same "any case"
    "IMWIDTH 4 imheight 3 CanvWidth 8 CANVHEIGHT 6 Depth 5 BColor RED \
     RayDepth 7"

let test_defaults () =
  let scene = Read.scene (Read.with_header "") in
  Alcotest.check Same.background "background"
    (Background.plain Color.black)
    scene.background;
  Alcotest.(check int) "ray depth" 4 scene.ray_depth

let test_layout () =
  let expected = Scene.make ~objects:[ ball ] Read.camera in
  check "comments" expected
    "# one\nsphere 0 0 # the middle\n  6 1 # radius\nreflective#end";
  check "CRLF" expected "objects\r\nsphere 0 0 6 1\r\nreflective\r\n";
  check "CR" expected "# one\robjects\rsphere 0 0 6 1 # two\rreflective\r";
  let text = Read.with_header "sphere 0 0 6 1 reflective" in
  Alcotest.check Same.scene "a byte order mark" expected
    (Read.scene ("\xef\xbb\xbf" ^ text))

(* Lights and objects know the lines of their first words, whatever ends a
   line. *)
let test_lines () =
  let scene =
    Read.scene
      (Read.with_header
         "lights\rspherical 1 red\n\
          0 0 0 directional 1 red 0 0 1\n\
          # a comment\robjects\r\n\
          \r\n\
          sphere 0 0 6 1\n\
          reflective plane 0 0 0\r0 1 0 reflective sphere 0 0 6 1 reflective")
  in
  let lines = Alcotest.(list (option int)) in
  let line origin =
    Option.map
      (fun { Provenance.place; _ } -> place.line)
      (Scene.provenance scene origin)
  in
  Alcotest.check lines "lights" [ Some 3; Some 4 ]
    (List.map (fun (light : Light.t) -> line light.origin) scene.lights);
  Alcotest.check lines "objects"
    [ Some 8; Some 9; Some 10 ]
    (List.map (fun (o : Object.t) -> line o.origin) scene.objects)

let suite =
  ( "Grammar",
    [
      Alcotest.test_case "objects" `Quick test_objects;
      Alcotest.test_case "lights" `Quick test_lights;
      Alcotest.test_case "header" `Quick test_header;
      Alcotest.test_case "defaults" `Quick test_defaults;
      Alcotest.test_case "layout" `Quick test_layout;
      Alcotest.test_case "lines" `Quick test_lines;
    ] )
