(* Which pixel shows what. *)

open Raylab_scene
open Test_support
open Build

(* 11 x 11 pixels on a canvas of 11 x 11, seen from 10 before it: the centres
   of the pixels are the points (i, j, 0) for i and j from -5 to 5. *)
let eleven =
  camera ~width:11 ~height:11 ~canvas_width:11. ~canvas_height:11. ~depth:10.
    ()

let glow = Surface.luminous Color.white

let check what expected objects =
  let letter (r, _, _) = if r = 0 then '.' else '#' in
  Alcotest.(check (list string))
    what expected
    (Shot.drawing letter (Shot.picture (Scene.make ~objects eleven)))

(* The line from the eye through (i, j, 0) passes the origin at the distance
   10 p / sqrt (100 + p^2), where p^2 = i^2 + j^2. That is less than 3 if
   91 p^2 < 900, so for p^2 up to 9: (3, 0) is in, (3, 1) is out. *)
let test_silhouette () =
  check "a sphere of radius 3"
    [
      "...........";
      "...........";
      ".....#.....";
      "...#####...";
      "...#####...";
      "..#######..";
      "...#####...";
      "...#####...";
      ".....#.....";
      "...........";
      "...........";
    ]
    [ sphere (v 0. 0. 0.) 3. glow ]

(* x from the left, y from the top: (-3, 4, 0) is in the third column of the
   second row. *)
let test_orientation () =
  let dot = "..#........" and none = "..........." in
  check "up to the left"
    (none :: dot :: List.init 9 (fun _ -> none))
    [ sphere (v (-3.) 4. 0.) 0.5 glow ]

(* The floor at -1 is seen where the ray falls, so below the middle row, whose
   rays are parallel to it. *)
let test_horizon () =
  check "a floor"
    (List.init 11 (fun y -> String.make 11 (if y <= 5 then '.' else '#')))
    [ plane (v 0. (-1.) 0.) (v 0. 1. 0.) glow ]

let test_primary_rays () =
  let scene =
    Scene.make
      (camera ~width:3 ~height:2 ~canvas_width:3. ~canvas_height:2. ())
  in
  let rays = List.of_seq (Camera.primary_rays scene.camera) in
  Alcotest.(check (list (Same.ray_near 1e-15)))
    "row by row from the top"
    (List.map
       (fun (x, y) -> ray (v 0. 0. (-1.)) (v x y 1.))
       [
         (-1., 0.5); (0., 0.5); (1., 0.5); (-1., -0.5); (0., -0.5); (1., -0.5);
       ] [@ocamlformat "disable"])
    rays

let suite =
  ( "Visibility",
    [
      Alcotest.test_case "silhouette" `Quick test_silhouette;
      Alcotest.test_case "orientation" `Quick test_orientation;
      Alcotest.test_case "horizon" `Quick test_horizon;
      Alcotest.test_case "primary rays" `Quick test_primary_rays;
    ] )
