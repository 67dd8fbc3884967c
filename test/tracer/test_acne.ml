(* No surface shades itself: where one that stands alone faces a light, it is
   lit, at every scale. *)

open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Test_support
open Build

let white = Surface.diffusive Color.white
let side = 40

(* Canvas and depth of [k] times 2 x 2 and 1. *)
let scene k ~light ~object_ =
  let camera =
    camera ~width:side ~height:side ~canvas_width:(2. *. k)
      ~canvas_height:(2. *. k) ~depth:k ()
  in
  Scene.make camera ~lights:[ light ] ~objects:[ object_ ]

(* What the light gives to the point that [ray] hits, nothing being in the way:
   worked out from the shape and the light alone. *)
let expected (scene : Scene.t) ray =
  let shape = (List.hd scene.objects).shape in
  match Shape.nearest shape ray with
  | None -> Color.black
  | Some (t, part) ->
      let point = Ray.at ray t in
      let outward = Shape.normal shape ~part point in
      let along = Vec3.dot (outward :> Vec3.t) (Ray.direction ray :> Vec3.t) in
      let normal = if along > 0. then Direction.neg outward else outward in
      Incidence.received (List.hd scene.lights) ~point ~normal

(* [check what ~least scene] looks at every pixel: one that hits the object
   where it faces the light is lit. At least [least] of them do. *)
let check what ~least scene =
  let prepared = Prepared.make scene and count = ref 0 in
  let look ray =
    let { Color.r; _ } = expected scene ray in
    (* at the edge of night rounding may decide *)
    if r > 1e-7 then (
      incr count;
      Alcotest.check
        (Same.color_near (1e-6 *. (r +. 1.)))
        what (grey r)
        (Tracer.color prepared ray))
  in
  Seq.iter look (Camera.primary_rays scene.camera);
  if !count < least then Alcotest.failf "%s: only %d pixels" what !count

let scales = [ 1e-3; 1e-2; 0.1; 1.; 10.; 100.; 1e3 ]

(* The pixels below the horizon, without those next to it, where what is seen is
   so far away that it is almost dark. *)
let half = (side * side / 2) - side

let at_each_scale what ~least make () =
  List.iter
    (fun k ->
      let light, object_ = make k in
      check
        (Printf.sprintf "%s, scale %g" what k)
        ~least (scene k ~light ~object_))
    scales

let bulb k = Shot.bulb ~intensity:(k *. k) k (3. *. k) 0.

let plane_under_bulb =
  at_each_scale "plane" ~least:half (fun k ->
      (bulb k, plane (v 0. (-.k) 0.) (v 0.1 1. 0.) white))

let plane_under_grazing_sun =
  at_each_scale "plane" ~least:half (fun k ->
      (Shot.sun 1. (-0.001) 0.3, plane (v 0. (-.k) 0.) (v 0. 1. 0.) white))

let sphere_under_bulb =
  at_each_scale "sphere" ~least:100 (fun k ->
      (bulb k, sphere (v 0. 0. (3. *. k)) (2. *. k) white))

let sphere_under_sun =
  at_each_scale "sphere" ~least:100 (fun k ->
      (Shot.sun 1. (-1.) 0.5, sphere (v 0. 0. (3. *. k)) (2. *. k) white))

(* From inside, rays to the light pass close to the sphere again. *)
let inside_sphere =
  at_each_scale "inside" ~least:(side * side) (fun k ->
      (bulb k, sphere (v 0. 0. 0.) (10. *. k) white))

let ground () =
  let ground = sphere (v 0. (-1e6 -. 1.) 0.) 1e6 white in
  check "under a bulb" ~least:half
    (scene 1. ~light:(Shot.bulb 1. 3. 0.) ~object_:ground);
  check "under a sun" ~least:half
    (scene 1. ~light:(Shot.sun 1. (-0.5) 0.3) ~object_:ground)

let far_away () =
  check "a plane at 1e9" ~least:(side * side)
    (scene 1. ~light:(Shot.sun 1. 0. 1.)
       ~object_:(plane (v 0. 0. 1e9) (v 0. 0. 1.) white));
  (* where doubles are further apart than the offset of everyday scales *)
  check "a slanted plane at 1e13" ~least:(side * side)
    (scene 1. ~light:(Shot.sun 1. 0. 1.)
       ~object_:(plane (v 0. 0. 1e13) (v 0.1 0.2 1.) white))

let suite =
  ( "Acne",
    [
      Alcotest.test_case "plane, bulb" `Quick plane_under_bulb;
      Alcotest.test_case "plane, low sun" `Quick plane_under_grazing_sun;
      Alcotest.test_case "sphere, bulb" `Quick sphere_under_bulb;
      Alcotest.test_case "sphere, sun" `Quick sphere_under_sun;
      Alcotest.test_case "inside a sphere" `Quick inside_sphere;
      Alcotest.test_case "a ground of radius 1e6" `Quick ground;
      Alcotest.test_case "far away" `Quick far_away;
    ] )
