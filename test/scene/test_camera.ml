open Raylab_geometry
open Raylab_scene
open Test_support
open Build

(* 4 x 2 pixels, each 1 x 1.5 of the canvas of 4 x 3; the eye 2 before it. *)
let four_by_two =
  camera ~width:4 ~height:2 ~canvas_width:4. ~canvas_height:3. ~depth:2. ()

let check_through what camera (x, y) canvas_x canvas_y =
  let depth = camera.Camera.depth in
  Alcotest.check (Same.ray_near 1e-15) what
    (ray (v 0. 0. (-.depth)) (v canvas_x canvas_y depth))
    (Camera.primary_ray camera ~x ~y)

(* By the formula, with j = 1 - y: x is -2 + 4 (x + 1/2) / 4 = x - 3/2, and y is
   -3/2 + 3 (j + 1/2) / 2, so 0.75 for the top row, where j = 1, and -0.75. *)
let test_corners () =
  let check what = check_through what four_by_two in
  check "top left" (0, 0) (-1.5) 0.75;
  check "top right" (3, 0) 1.5 0.75;
  check "bottom left" (0, 1) (-1.5) (-0.75);
  check "bottom right" (3, 1) 1.5 (-0.75);
  (* x = -1 is one pixel further left *)
  check "outside" (-1, 0) (-2.5) 0.75

let test_canvas () =
  let low, high = Camera.canvas four_by_two in
  Alcotest.check Same.vec3 "lower left" (v (-2.) (-1.5) 0.) low;
  Alcotest.check Same.vec3 "upper right" (v 2. 1.5 0.) high

let test_centre () =
  let odd = camera ~width:5 ~height:3 ~depth:7. () in
  Alcotest.check Same.direction "straight ahead" (dir 0. 0. 1.)
    (Ray.direction (Camera.primary_ray odd ~x:2 ~y:1));
  Alcotest.check Same.vec3 "from the eye" (v 0. 0. (-7.)) (Camera.eye odd)

(* Canvas 4 x 3 again, now with pixels of 0.5 x 0.5: the first one is centred
   0.25 from the edges. *)
let test_with_size () =
  let finer = Camera.with_size ~width:8 ~height:6 four_by_two in
  check_through "top left" finer (0, 0) (-1.75) 1.25;
  Expect.invalid "width 0" (fun () ->
      Camera.with_size ~width:0 ~height:6 four_by_two);
  Expect.invalid "height too large" (fun () ->
      Camera.with_size ~width:1 ~height:(Camera.max_size + 1) four_by_two)

let test_scale () =
  let scale canvas_width canvas_height depth =
    Camera.scale (camera ~canvas_width ~canvas_height ~depth ())
  in
  Alcotest.check Same.number "width" 1. (scale 1. 2. 3.);
  Alcotest.check Same.number "height" 1. (scale 2. 1. 3.);
  Alcotest.check Same.number "depth" 1. (scale 3. 2. 1.)

let test_invalid () =
  List.iter
    (fun bad ->
      Expect.invalid "canvas width" (fun () -> camera ~canvas_width:bad ());
      Expect.invalid "canvas height" (fun () -> camera ~canvas_height:bad ());
      Expect.invalid "depth" (fun () -> camera ~depth:bad ()))
    [ 0.; -1.; nan; infinity ];
  List.iter
    (fun bad ->
      Expect.invalid "width" (fun () -> camera ~width:bad ());
      Expect.invalid "height" (fun () -> camera ~height:bad ()))
    [ 0; -1; Camera.max_size + 1; min_int; max_int ];
  Alcotest.(check int)
    "largest" 2147483647
    (camera ~width:Camera.max_size ~height:Camera.max_size ()).width

let unit_length =
  Property.holds "a primary ray has a direction, whatever the numbers"
    (Generate.scene ~max_side:1000 Generate.extreme) (fun scene ->
      let camera = scene.camera in
      List.for_all
        (fun (x, y) ->
          let ray = Camera.primary_ray camera ~x ~y in
          let d = (Ray.direction ray :> Vec3.t) in
          abs_float (Vec3.length d -. 1.) < 1e-15)
        [ (0, 0); (camera.width - 1, camera.height - 1) ])

let suite =
  ( "Camera",
    [
      Alcotest.test_case "corner pixels" `Quick test_corners;
      Alcotest.test_case "canvas" `Quick test_canvas;
      Alcotest.test_case "centre pixel" `Quick test_centre;
      Alcotest.test_case "with_size" `Quick test_with_size;
      Alcotest.test_case "scale" `Quick test_scale;
      Alcotest.test_case "invalid" `Quick test_invalid;
      unit_length;
    ] )
