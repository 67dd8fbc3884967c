open Raylab_scene
open Test_support

let camera width height =
  Build.camera ~width ~height ~canvas_width:4. ~canvas_height:3. ()

let test_distortion () =
  let check (width, height) expected =
    Alcotest.(check (option string))
      (Printf.sprintf "%d x %d" width height)
      expected
      (Proportions.distortion (camera width height))
  in
  check (640, 480) None;
  check (640, 481) None;
  check (1280, 480) (Some "2 times as wide as it should");
  check (640, 960) (Some "2 times as high as it should");
  check (640, 500) (Some "1.04 times as high as it should");
  (* 5 x 3.75 and 4.7 x 3.5 *)
  check (5, 4) None;
  check (1, 1) None;
  check (5, 5) (Some "1.33 times as high as it should");
  check (1, 2147483647) (Some "2.86e+09 times as high as it should")

let test_fitting () =
  let check width expected =
    Alcotest.(check int)
      (string_of_int width) expected
      (Proportions.fitting_height (camera width 7))
  in
  check 640 480;
  check 5 4;
  check 1 1

let suite =
  ( "Proportions",
    [
      Alcotest.test_case "distortion" `Quick test_distortion;
      Alcotest.test_case "fitting height" `Quick test_fitting;
    ] )
