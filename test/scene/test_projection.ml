open Raylab_geometry
open Raylab_scene
open Test_support

let camera =
  Camera.make ~width:100 ~height:80 ~canvas_width:10. ~canvas_height:8.
    ~depth:5.

let vec = Vec3.make
let point = Alcotest.(pair (float 1e-6) (float 1e-6))

let pixels_and_lengths =
  QCheck2.Gen.(triple (int_range 0 99) (int_range 0 79) (float_range 0.1 1e4))

let is_seen_in camera x y point =
  match Camera.project camera point with
  | None -> false
  | Some (u, v) ->
      Float.abs (u -. (float_of_int x +. 0.5)) < 1e-6
      && Float.abs (v -. (float_of_int y +. 0.5)) < 1e-6

let inverse =
  Property.holds "a point on a primary ray is seen in its pixel"
    ~print:QCheck2.Print.(triple int int float)
    pixels_and_lengths
    (fun (x, y, t) ->
      is_seen_in camera x y (Ray.at (Camera.primary_ray camera ~x ~y) t))

(* And one on the other side of the eye is not seen. *)
let inverse_anywhere =
  Property.holds "likewise of a camera anywhere" ~count:2000
    ~print:(fun (viewpoint, (x, y, t)) ->
      Printf.sprintf "(%d, %d) at %g: %s" x y t
        (Property.show Viewpoint.pp viewpoint))
    QCheck2.Gen.(
      pair (Generate.viewpoint Generate.everyday) pixels_and_lengths)
    (fun (viewpoint, (x, y, t)) ->
      List.for_all
        (fun camera ->
          let ray = Camera.primary_ray camera ~x ~y in
          is_seen_in camera x y (Ray.at ray t)
          && Camera.project camera (Ray.at ray (-.t)) = None)
        [
          Camera.with_viewpoint viewpoint camera;
          Camera.of_fov ~width:100 ~height:80 ~fov:70. viewpoint;
        ])

let test_behind () =
  let check name p =
    Alcotest.(check (option point)) name None (Camera.project camera p)
  in
  check "behind the eye" (vec 0. 0. (-6.));
  check "beside the eye" (vec 1. 0. (-5.));
  check "the eye" (Camera.eye camera)

let ray origin target =
  Ray.make ~origin ~direction:(Direction.of_vec3_exn (Vec3.sub target origin))

let test_rays () =
  let check name expected ray length =
    Alcotest.(check (option (pair point point)))
      name expected
      (Camera.project_ray camera ray ~length)
  in
  let middle = (50., 40.) in
  check "in the canvas"
    (Some (middle, (70., 30.)))
    (ray Vec3.zero (vec 2. 1. 0.))
    (sqrt 5.);
  check "without end, away from the eye: to where such rays vanish"
    (Some ((70., 40.), middle))
    (ray (vec 2. 0. 0.) (vec 2. 0. 1.))
    infinity;
  check "a ray to the eye is seen as a point"
    (Some (middle, middle))
    (ray (vec 0. 0. 3.) (Camera.eye camera))
    infinity;
  check "behind the eye" None (ray (vec 0. 0. (-6.)) (vec 0. 1. (-6.))) 3.;
  match
    Camera.project_ray camera (ray Vec3.zero (vec 1. 0. (-1.))) ~length:1e3
  with
  | Some (a, (x, y)) ->
      Alcotest.check point "from where it starts" middle a;
      Alcotest.(check (float 1e-6)) "level" 40. y;
      Alcotest.(check bool) "far to the right, before the eye" true (x > 1e4)
  | None -> Alcotest.fail "passing the eye: not seen"

let suite =
  ( "Projection",
    [
      inverse;
      inverse_anywhere;
      Alcotest.test_case "behind the eye" `Quick test_behind;
      Alcotest.test_case "rays" `Quick test_rays;
    ] )
