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

let check_corners what camera expected =
  let a, b, c, d = Camera.corners camera in
  List.iter2
    (Alcotest.check (Same.vec3_near 1e-15) what)
    expected [ a; b; c; d ]

let test_canvas () =
  check_corners "not placed" four_by_two
    [ v (-2.) (-1.5) 0.; v 2. (-1.5) 0.; v 2. 1.5 0.; v (-2.) 1.5 0. ];
  (* from (5, 0, 1) towards -x, so that z is to the right *)
  let viewpoint = Viewpoint.make_exn ~look_at:(v 0. 0. 1.) (v 5. 0. 1.) in
  check_corners "placed"
    (Camera.with_viewpoint viewpoint four_by_two)
    [ v 3. (-1.5) (-1.); v 3. (-1.5) 3.; v 3. 1.5 3.; v 3. 1.5 (-1.) ]

(* At 90 degrees the canvas is twice as wide as it is far away. *)
let test_fov () =
  let viewpoint = Viewpoint.make_exn ~look_at:(v 0. 0. 1.) (v 5. 0. 1.) in
  let camera = Camera.of_fov ~width:40 ~height:10 ~fov:90. viewpoint in
  let size { Camera.canvas_width; canvas_height; depth; _ } =
    v canvas_width canvas_height depth
  in
  Alcotest.check Same.vec3 "the canvas" (v 10. 2.5 5.) (size camera);
  check_corners "at the point looked at" camera
    [ v 0. (-1.25) (-4.); v 0. (-1.25) 6.; v 0. 1.25 6.; v 0. 1.25 (-4.) ];
  Alcotest.check Same.vec3 "in the picture's proportions, whatever its size"
    (v 10. 5. 5.)
    (size (Camera.with_size ~width:8 ~height:4 camera));
  Alcotest.check Same.vec3 "under the same angle" (v 4. 1. 2.)
    (size (Camera.with_viewpoint (Viewpoint.make_exn (v 0. 0. 2.)) camera));
  List.iter
    (fun fov ->
      Expect.invalid (string_of_float fov) (fun () ->
          Camera.of_fov ~width:40 ~height:10 ~fov viewpoint))
    [ 0.; -1.; 180.; 5e-324; nan; infinity ]

let fills_the_angle =
  Property.holds "fov is the angle between the edges"
    QCheck2.Gen.(
      triple
        (Generate.viewpoint Generate.everyday)
        (float_range 0.1 179.9) (1 -- 100))
    (fun (viewpoint, fov, width) ->
      let camera = Camera.of_fov ~width ~height:1 ~fov viewpoint in
      let edge dx =
        (Ray.direction (Camera.ray_through camera ~x:0 ~y:0 ~dx ~dy:0.5)
          :> Vec3.t)
      in
      let left = edge 0. and right = edge (float_of_int width) in
      let angle =
        2.
        *. Float.atan2
             (Vec3.length (Vec3.sub left right))
             (Vec3.length (Vec3.add left right))
      in
      abs_float ((angle *. 180. /. Float.pi) -. fov) < 1e-7)

(* The formulas of cameras before they could be placed. *)
let unplaced { Camera.width; height; canvas_width; canvas_height; depth; _ } x
    y =
  let along extent count k =
    (-.extent /. 2.)
    +. (extent *. (float_of_int k +. 0.5) /. float_of_int count)
  in
  let dx = along canvas_width width x
  and dy = along canvas_height height (height - 1 - y) in
  let squared = (dx *. dx) +. (dy *. dy) +. (depth *. depth) in
  let direction =
    if squared > 1e-280 && squared < 1e280 then
      let scale = 1. /. sqrt squared in
      Vec3.make (dx *. scale) (dy *. scale) (depth *. scale)
    else
      let z_axis = dir 0. 0. 1. in
      (Direction.of_vec3_or z_axis (Vec3.make dx dy depth) :> Vec3.t)
  in
  (Vec3.make 0. 0. (-.depth), direction)

let same_bits =
  Property.holds "rays of a camera that is not placed, bit for bit" ~count:2000
    (Generate.camera Generate.extreme) (fun camera ->
      Camera.is_placed camera
      || List.for_all
           (fun (x, y) ->
             let ray = Camera.primary_ray camera ~x ~y in
             let direction = (Ray.direction ray :> Vec3.t) in
             let origin, direction' = unplaced camera x y in
             compare (Ray.origin ray) origin = 0
             && compare direction direction' = 0)
           [ (0, 0); (camera.width - 1, camera.height - 1); (3, 1) ])

(* The last pixels of the largest pictures are beyond those that are kept. *)
let same_at_centres =
  Property.holds "a ray through a centre that is kept, bit for bit" ~count:500
    (Generate.camera Generate.extreme) (fun camera ->
      let centres = Camera.centres camera and ray = Raw_ray.create () in
      List.for_all
        (fun (x, y) ->
          Camera.aim_at_centre camera centres ~x ~y ray;
          compare (Ray.of_raw ray) (Camera.primary_ray camera ~x ~y) = 0)
        [
          (0, 0);
          (camera.width - 1, camera.height - 1);
          (camera.width, 0);
          (3, 1);
          (-1, 2);
          (0x10000, 0x10000);
        ])

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
    [ 0; -1; Camera.max_size + 1; min_int ];
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
      Alcotest.test_case "fov" `Quick test_fov;
      fills_the_angle;
      same_bits;
      same_at_centres;
      Alcotest.test_case "centre pixel" `Quick test_centre;
      Alcotest.test_case "with_size" `Quick test_with_size;
      Alcotest.test_case "scale" `Quick test_scale;
      Alcotest.test_case "invalid" `Quick test_invalid;
      unit_length;
    ] )
