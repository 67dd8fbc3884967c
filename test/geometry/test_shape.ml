open Raylab_geometry
open Test_support
open Build

let ball = Shape.sphere ~centre:(v 0. 0. 6.) ~radius:1.
let floor = Shape.plane ~point:(v 0. (-1.) 0.) ~normal:(v 0. 2. 0.)
let z_axis = ray Vec3.zero (v 0. 0. 1.)

let test_sphere () =
  Alcotest.(check (list (Same.near 1e-14)))
    "intersections" [ 5.; 7. ]
    (Shape.intersections ball z_axis);
  Alcotest.check (Same.near 1e-14) "nearest" 5. (Shape.nearest ball z_axis);
  Alcotest.check Same.direction "outward" (dir 0. 0. (-1.))
    (Shape.normal ball (v 0. 0. 5.));
  Alcotest.(check string) "name" "sphere" (Shape.name ball);
  Expect.prints "pp" "sphere centre (0, 0, 6) radius 1" Shape.pp ball

(* The normal is as given, but of length 1, wherever the ray comes from. *)
let test_plane () =
  let down = ray (v 0. 1. 0.) (v 0. (-1.) 0.) in
  Alcotest.(check (list (Same.near 1e-14)))
    "intersections" [ 2. ]
    (Shape.intersections floor down);
  Alcotest.check Same.direction "as given" (dir 0. 1. 0.)
    (Shape.normal floor (v 0. (-1.) 0.));
  Alcotest.(check string) "name" "plane" (Shape.name floor);
  Expect.prints "pp" "plane point (0, -1, 0) normal (0, 1, 0)" Shape.pp floor;
  Expect.invalid "zero normal" (fun () ->
      Shape.plane ~point:Vec3.zero ~normal:Vec3.zero)

let test_depth () =
  let check what expected shape (x, y, z) =
    Alcotest.check (Same.near 1e-14) what expected
      (Shape.depth shape (v x y z))
  in
  check "centre" 1. ball (0., 0., 6.);
  check "inside" 0.25 ball (0., 0.75, 6.);
  check "on the ball" 0. ball (0., 0., 7.);
  check "outside" (-2.) ball (0., 0., 9.);
  check "a plane is not closed" neg_infinity floor (5., -4., 5.)

let test_place () =
  let check what expected a b =
    Alcotest.(check bool) what expected (Shape.place a = Shape.place b)
  in
  let plane (x, y, z) normal = Shape.plane ~point:(v x y z) ~normal in
  check "another point and normal" true floor
    (plane (3., -1., 2.) (v 0. (-0.5) 0.));
  check "a tilted plane" true
    (plane (1., 0., 0.) (v 1. 1. 1.))
    (plane (0., 0.5, 0.5) (v (-2.) (-2.) (-2.)));
  check "through the origin" true
    (plane (0., 0., 0.) (v 1. (-1.) 0.))
    (plane (0.3, 0.3, 7.) (v (-1.) 1. 0.));
  check "the other side" false floor (plane (0., 1., 0.) (v 0. 1. 0.));
  check "a ball" false ball floor;
  check "another ball" false ball
    (Shape.sphere ~centre:(v 0. 0. 6.) ~radius:1.5)

let test_equal () =
  let differs what other =
    Alcotest.(check bool) what false (Shape.equal ball other)
  in
  Alcotest.(check bool) "itself" true (Shape.equal ball ball);
  Alcotest.(check bool) "a plane" true (Shape.equal floor floor);
  differs "centre" (Shape.sphere ~centre:(v 0. 0. 7.) ~radius:1.);
  differs "radius" (Shape.sphere ~centre:(v 0. 0. 6.) ~radius:2.);
  differs "kind" floor

(* What is written after the word is what the shape is made of. *)
let test_parts () =
  let check what expected shape =
    Alcotest.(check bool) what true (Shape.parts shape = expected)
  in
  check "sphere"
    [ ("centre", Vector (v 0. 0. 6.)); ("radius", Number 1.) ]
    ball;
  check "plane"
    [ ("point", Vector (v 0. (-1.) 0.)); ("normal", Vector (v 0. 1. 0.)) ]
    floor

(* Every point of a shape is in its ball. *)
let ball_holds =
  Property.holds "the ball holds the shape" ~count:5000
    QCheck2.Gen.(
      pair (Generate.shape Generate.everyday) (Generate.ray Generate.everyday))
    (fun (shape, ray) ->
      match Shape.ball shape with
      | None -> true
      | Some ball ->
          let is_inside t =
            let way = Vec3.sub (Ray.at ray t) (Sphere.centre ball) in
            Vec3.length way <= ball.radius +. 1e-6
          in
          List.for_all is_inside (Shape.intersections shape ray))

let shapes_and_rays number =
  QCheck2.Gen.pair (Generate.shape number) (Generate.ray number)

(* [nearest] is a faster way to say this of all intersections. *)
let least_positive ts =
  List.fold_left Float.min infinity (List.filter (fun t -> t > 0.) ts)

let nearest_is_least =
  Property.holds "nearest is the least positive intersection" ~count:5000
    (shapes_and_rays Generate.extreme) (fun (shape, ray) ->
      Shape.nearest shape ray = least_positive (Shape.intersections shape ray))

let suite =
  ( "Shape",
    [
      Alcotest.test_case "sphere" `Quick test_sphere;
      Alcotest.test_case "plane" `Quick test_plane;
      Alcotest.test_case "depth" `Quick test_depth;
      Alcotest.test_case "place" `Quick test_place;
      Alcotest.test_case "equal" `Quick test_equal;
      Alcotest.test_case "parts" `Quick test_parts;
      ball_holds;
      nearest_is_least;
    ] )
