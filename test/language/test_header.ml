(* Every rule about the header; the errors are marked below the lines. *)

open Raylab_scene

let check what block =
  Read.check_errors what ("\ncanvWidth 4 canvHeight 3 depth 4" ^ block)

let test_whole_numbers () =
  check "0"
    {|
imWidth 0 imHeight 3
        ^ imWidth must be a whole number from 1 to 2147483647, not 0
|};
  check "negative"
    {|
imWidth -640 imHeight 3
        ^^^^ imWidth must be a whole number from 1 to 2147483647, not -640
|};
  check "with a point"
    {|
imWidth 640. imHeight 3
        ^^^^ imWidth must be a whole number from 1 to 2147483647, not 640.
|};
  check "with an exponent"
    {|
imWidth 1e3 imHeight 3
        ^^^ imWidth must be a whole number from 1 to 2147483647, not 1e3
|};
  check "too large"
    {|
imWidth 2147483648 imHeight 3
        ^^^^^^^^^^ imWidth must be a whole number from 1 to 2147483647, not ...
|};
  check "height"
    {|
imWidth 4 imHeight 2.5
                   ^^^ imHeight must be a whole number from 1 to 2147483647, ...
|};
  check "ray depth"
    {|
imWidth 4 imHeight 3 raydepth -1
                              ^^ raydepth must be a whole number from 0 to ...
|};
  check "ray depth too large"
    {|
imWidth 4 imHeight 3 raydepth 1000001
                              ^^^^^^^ raydepth must be a whole number from 0 ...
|}

let test_lengths () =
  Read.check_errors "each"
    {|
imWidth 4 imHeight 3 bcolor 0 -1 0
                              ^^ the green of bcolor must not be negative, ...
canvWidth 0 canvHeight -3 depth 1e999
          ^ canvWidth must be greater than 0, not 0
                       ^^ canvHeight must be greater than 0, not -3
                                ^^^^^ depth must be a finite number, not 1e999
|}

(* A second setting is in error at its keyword. *)
let test_twice () =
  check "the same"
    {|
imWidth 4 imHeight 3 imWidth 4
                     ^^^^^^^ imWidth is set a second time
|};
  check "both names of the background"
    {|
bcolor red imWidth 4 imHeight 3
bgcolor red
^^^^^^^ bcolor is set a second time
|};
  check "a value in error and a second time"
    {|
imWidth 4 imHeight 3
imWidth 0
^^^^^^^ imWidth is set a second time
        ^ imWidth must be a whole number from 1 to 2147483647, not 0
|}

(* What lacks is in error where the header ends. *)
let test_missing () =
  check "one"
    {|
raydepth 5 imWidth 4
                    ^ the header lacks imHeight
# no more
sphere 0 0 6 1 reflective
|};
  Read.check_errors "all"
    {|
sphere 0 0 6 1 reflective
^ the header lacks imWidth, imHeight, canvWidth, canvHeight, depth
|};
  Read.check_errors "nothing at all"
    {|

^ the header lacks imWidth, imHeight, canvWidth, canvHeight, depth
|}

(* All of them in one run, in the order of the text. *)
let test_all_at_once () =
  Read.check_errors "a scene full of errors"
    {|
imWidth 0 canvWidth 4 canvHeight 3 depth -4
        ^ imWidth must be a whole number from 1 to 2147483647, not 0
                                         ^^ depth must be greater than 0, not -4
                                           ^ the header lacks imHeight
lights
directional -1 red 0 0 0
            ^^ the intensity must not be negative, not -1
                   ^^^^^ the direction must not be the zero vector
objects
sphere 0 0 6 0 diffusive -1 -2 0
             ^ the radius must be greater than 0, not 0
                         ^^ the red of the surface's colour must not be ...
                            ^^ the green of the surface's colour must not be ...
|}

let sizes = "canvWidth 4 canvHeight 3 depth 4"

let test_allowed () =
  let scene =
    Read.scene (sizes ^ " imWidth +640 imHeight 0480 raydepth 0 bcolor 9 9 9")
  in
  Alcotest.(check int) "a sign" 640 scene.camera.width;
  Alcotest.(check int) "a zero before" 480 scene.camera.height;
  Alcotest.(check int) "raydepth 0" 0 scene.ray_depth;
  let scene = Read.scene (sizes ^ " imWidth 2147483647 imHeight 1") in
  Alcotest.(check int) "the most" 2147483647 scene.camera.width

(* {1 The camera} *)

let view what block = Read.check_errors what ("\nimWidth 4 imHeight 3" ^ block)

let test_camera_missing () =
  view "fov alone"
    {|
fov 60
^^^ fov needs eye, the point from which the angle is seen
|};
  view "both"
    {|
depth 4 fov 60 eye 0 0 -4 canvWidth 3
        ^^^ fov stands beside canvWidth and depth, and both say how much one sees
|};
  view "neither"
    {|
eye 0 0 -4
          ^ the header lacks fov (or canvWidth, canvHeight and depth)
|};
  view "half a canvas"
    {|
eye 0 0 -4 depth 4
                  ^ the header lacks canvWidth, canvHeight
|};
  Read.check_errors "no picture"
    {|
fov 60 eye 0 0 -4
                 ^ the header lacks imWidth, imHeight
|}

let test_camera_values () =
  view "the angle"
    {|
fov 180 eye 0 0 -4
^^^ fov must be less than 180 degrees
|};
  view "no angle"
    {|
fov -1 eye 0 0 -4
    ^^ fov must be greater than 0, not -1
|};
  view "a canvas of no width"
    {|
fov 5e-324 eye 0 0 -4
^^^ the canvas under this angle leaves the range of numbers
|};
  view "up"
    {|
fov 60 eye 0 0 -4 up 0 0 0
                     ^^^^^ up must not be the zero vector
|};
  view "nothing follows from what is wrong"
    {|
fov 60 eye 0 0 1e999 lookAt 1 1 1
               ^^^^^ the z of eye must be a finite number, not 1e999
|};
  view "names are evaluated"
    {|
let p = [0, 0, 0]
fov 60 eye [p] up [p]
                   ^ up must not be the zero vector
|}

let test_camera_contradicts () =
  view "at the point looked at"
    {|
fov 60 eye 1 2 3 lookAt 1 2 3
                 ^^^^^^ eye and lookAt are the same point
|};
  view "at the origin"
    {|
fov 60 eye 0 0 0
       ^^^ eye is 0 0 0, the point at which it looks unless lookAt says otherwise
|};
  view "looking at the usual eye"
    {|
canvWidth 4 canvHeight 3 depth 4 lookAt 0 0 -4
                                 ^^^^^^ lookAt is 0 0 -4, where the eye is ...
|};
  view "from above"
    {|
fov 60 eye 0 4 0
       ^^^ the eye looks along up, so that no direction is up in the picture
|};
  view "along up"
    {|
fov 60 eye 1 1 1 up 2 2 2
                 ^^ the eye looks along up, so that no direction is up in the ...
|}

let test_camera () =
  let v = Test_support.Build.v in
  let check what expected text =
    Alcotest.(check bool)
      what true
      (Camera.equal expected
         (Read.scene ("imWidth 8 imHeight 6 " ^ text)).camera)
  in
  let usual =
    Camera.make ~width:8 ~height:6 ~canvas_width:4. ~canvas_height:3. ~depth:4.
  in
  check "today's" usual (sizes ^ " eye 0 0 -4 lookAt 0 0 0 up 0 1 0");
  check "moved"
    (Camera.with_viewpoint
       (Viewpoint.make_exn ~look_at:(v 0. 0. 3.) ~up:(v 1. 0. 0.) (v 1. 2. 3.))
       usual)
    ("up 1 0 0 lookAt 0 0 3 " ^ sizes ^ " eye 1 2 3");
  check "turned on the spot"
    (Camera.with_viewpoint
       (Viewpoint.make_exn ~look_at:(v 1. 0. 0.) (v 0. 0. (-4.)))
       usual)
    (sizes ^ " lookAt 1 0 0");
  check "an angle"
    (Camera.of_fov ~width:8 ~height:6 ~fov:60.
       (Viewpoint.make_exn (v 1. 2. 3.)))
    "let d = 2 fov (30 * d) eye [(d - 1), d, 3]"

let suite =
  ( "Header",
    [
      Alcotest.test_case "whole numbers" `Quick test_whole_numbers;
      Alcotest.test_case "lengths and colour" `Quick test_lengths;
      Alcotest.test_case "twice" `Quick test_twice;
      Alcotest.test_case "missing" `Quick test_missing;
      Alcotest.test_case "all at once" `Quick test_all_at_once;
      Alcotest.test_case "allowed" `Quick test_allowed;
      Alcotest.test_case "what a camera lacks" `Quick test_camera_missing;
      Alcotest.test_case "numbers of a camera" `Quick test_camera_values;
      Alcotest.test_case "no camera" `Quick test_camera_contradicts;
      Alcotest.test_case "cameras" `Quick test_camera;
    ] )
