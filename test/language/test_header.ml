(* Every rule about the header; the errors are marked below the lines. *)

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

let suite =
  ( "Header",
    [
      Alcotest.test_case "whole numbers" `Quick test_whole_numbers;
      Alcotest.test_case "lengths and colour" `Quick test_lengths;
      Alcotest.test_case "twice" `Quick test_twice;
      Alcotest.test_case "missing" `Quick test_missing;
      Alcotest.test_case "all at once" `Quick test_all_at_once;
      Alcotest.test_case "allowed" `Quick test_allowed;
    ] )
