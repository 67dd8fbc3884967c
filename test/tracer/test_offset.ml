(* Rays leave a surface 1e-5 from it where canvas and depth measure about 1, as
   in the original, and as much of the scene's lengths at every other scale. *)

open Raylab_scene
open Raylab_tracer
open Test_support
open Build

let white = Surface.diffusive Color.white

(* The wall is hit at (0, 0, 4 k), and lit along (0, -1, 1), from above and from
   before it. The sphere of radius h / 2 around (0, h, 4 k - h) stands in the
   way of that light, and beside that of the ray from the eye. *)
let shot k h =
  let camera =
    camera ~canvas_width:(2. *. k) ~canvas_height:(2. *. k) ~depth:k ()
  in
  let scene =
    Scene.make camera
      ~lights:[ Shot.sun 0. (-1.) 1. ]
      ~objects:
        [
          plane (v 0. 0. (4. *. k)) (v 0. 0. 1.) white;
          sphere (v 0. h ((4. *. k) -. h)) (h /. 2.) white;
        ]
  in
  Tracer.pixel (Prepared.make scene) ~x:0 ~y:0

(* The sphere reaches from h / 2 to 3 h / 2 before the wall. With h = 5e-6 k
   that is less than 1e-5 k, so the shadow ray starts beyond it. *)
let test_offset () =
  List.iter
    (fun k ->
      let check what expected h =
        Alcotest.check (Same.color_near 1e-9)
          (Printf.sprintf "%s, scale %g" what k)
          (grey expected)
          (shot k (h *. k))
      in
      check "a shadow" 0. 0.1;
      check "just a shadow" 0. 4e-5;
      (* the cosine of 45 degrees *)
      check "too near" (sqrt 0.5) 5e-6)
    [ 1e-3; 1.; 1e3 ]

let suite = ("Offset", [ Alcotest.test_case "offset" `Quick test_offset ])
