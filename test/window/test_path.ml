open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Raylab_window

let camera =
  Camera.make ~width:100 ~height:80 ~canvas_width:10. ~canvas_height:8.
    ~depth:5.

let vec = Vec3.make
let point = Alcotest.(pair (float 1e-6) (float 1e-6))

let prop_inverse =
  QCheck.Test.make ~name:"a point on a primary ray is seen in its pixel"
    QCheck.(triple (int_range 0 99) (int_range 0 79) (float_range 0.1 1e4))
    (fun (x, y, t) ->
      match
        Camera.project camera (Ray.at (Camera.primary_ray camera ~x ~y) t)
      with
      | None -> false
      | Some (u, v) ->
          Float.abs (u -. (float_of_int x +. 0.5)) < 1e-6
          && Float.abs (v -. (float_of_int y +. 0.5)) < 1e-6)

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

(* A mirror before the eye, a wall behind it, two lights. *)
let overlay ~first_row =
  let scene =
    Scene.make camera ~ray_depth:2
      ~lights:
        [
          Light.spherical ~intensity:1. ~color:Color.white
            ~position:(vec 0. 3. 5.);
          Light.spherical ~intensity:1. ~color:Color.white
            ~position:(vec 0. 0. 30.);
        ]
      ~objects:
        [
          Object.make
            (Shape.plane ~point:(vec 0. 0. 10.) ~normal:(vec 0. 0. (-1.)))
            (Surface.mixed
               [
                 (1., Surface.diffusive Color.white); (1., Surface.reflective);
               ]);
          Object.make
            (Shape.sphere ~centre:(vec 0. 1.5 7.5) ~radius:0.2)
            (Surface.luminous Color.red);
        ]
  in
  let e = Explain.centre (Explain.pixel (Trace.prepare scene) ~x:50 ~y:40) in
  Path_overlay.make camera ~first_row e

let test_overlay () =
  let { Path_overlay.lines; hits; blocks } = overlay ~first_row:0 in
  Alcotest.(check int) "hits" 1 (List.length hits);
  Alcotest.(check (list string))
    "rays"
    [ "to a light, blocked"; "mirrored ray" ]
    (List.map (fun (role, _) -> Path_overlay.name role) lines);
  Alcotest.(check int) "blocks" 1 (List.length blocks);
  let x, y = List.hd hits in
  Alcotest.check point "the hit is the pixel" (50.5, 40.5) (x, y)

let test_rows () =
  let y overlay = snd (List.hd overlay.Path_overlay.hits) in
  Alcotest.(check (float 1e-9))
    "rows count from the first that is shown"
    (y (overlay ~first_row:0) -. 30.)
    (y (overlay ~first_row:30))

let suite =
  ( "Path",
    [
      QCheck_alcotest.to_alcotest prop_inverse;
      Alcotest.test_case "behind the eye" `Quick test_behind;
      Alcotest.test_case "rays" `Quick test_rays;
      Alcotest.test_case "overlay" `Quick test_overlay;
      Alcotest.test_case "a band of rows" `Quick test_rows;
    ] )
