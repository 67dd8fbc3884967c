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
  Alcotest.(check (option (pair (Same.near 1e-14) int)))
    "nearest, of its only part"
    (Some (5., 0))
    (Shape.nearest ball z_axis);
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
let test_parameters () =
  let check what expected shape =
    Alcotest.(check bool) what true (Shape.parameters shape = expected)
  in
  check "sphere"
    [ ("centre", Triple (0., 0., 6.)); ("radius", Number 1.) ]
    ball;
  check "plane"
    [ ("point", Triple (0., -1., 0.)); ("normal", Triple (0., 1., 0.)) ]
    floor

let shapes_and_rays number =
  QCheck2.Gen.pair (Generate.shape number) (Generate.ray number)

let is_inside e { Box3.low; high } { Vec3.x; y; z } =
  let within low x high = low -. e <= x && x <= high +. e in
  within low.x x high.x && within low.y y high.y && within low.z z high.z

(* With the place on the shape that a hit is brought to. *)
let box_holds =
  Property.holds "the box holds every hit" ~count:5000
    (shapes_and_rays Generate.everyday) (fun (shape, ray) ->
      (* where faces of a solid meet, rounding decides which is met *)
      let tolerance = match shape with Solid _ -> 1e-6 | _ -> 1e-14 in
      let holds box (t, part, _) =
        is_inside 1e-6 box (Ray.at ray t)
        && is_inside tolerance box
             (Spot.point (Ask.spot shape ~part ~reach:t ray))
      in
      match Shape.box shape with
      | None -> true
      | Some box -> List.for_all (holds box) (Ask.crossings shape ray))

(* Centre + radius * direction, and the box is no larger than it must be. *)
let box_of_sphere =
  Property.holds "the box of a sphere holds and touches it" ~count:2000
    QCheck2.Gen.(
      triple
        (Generate.vec3 Generate.everyday)
        (Generate.positive Generate.everyday)
        (Generate.direction Generate.everyday))
    (fun (centre, radius, direction) ->
      let box = Option.get (Shape.box (Shape.sphere ~centre ~radius)) in
      let point along = Vec3.add centre (Vec3.scale radius along) in
      let poles = [ v 1. 0. 0.; v 0. 1. 0.; v 0. 0. 1. ] in
      is_inside 1e-14 box (point (direction :> Vec3.t))
      && List.for_all
           (fun pole ->
             let outside = Vec3.scale 1.000001 pole in
             is_inside 0. box (point pole)
             && is_inside 0. box (point (Vec3.neg pole))
             && (not (is_inside 0. box (point outside)))
             && not (is_inside 0. box (point (Vec3.neg outside))))
           poles)

let test_box () =
  Alcotest.(check bool) "a plane has none" true (Shape.box floor = None)

(* [nearest] is a faster way to say this of all crossings. *)
let nearest_is_least =
  Property.holds "nearest is the first crossing in front" ~count:5000
    (shapes_and_rays Generate.extreme) (fun (shape, ray) ->
      let ahead (c : Crossings.crossing) = c.t > 0. in
      let first = List.find_opt ahead (Shape.crossings shape ray) in
      Shape.nearest shape ray
      = Option.map (fun (c : Crossings.crossing) -> (c.t, c.part)) first)

let from_axis centre (axis : Direction.t) point =
  let p = Vec3.sub point centre and w = (axis :> Vec3.t) in
  let height = Vec3.dot p w in
  (height, Vec3.length (Vec3.sub p (Vec3.scale height w)))

let frustum_holds { Frustum.a; axis; radius_a; length; slope; _ } point =
  let height, across = from_axis a axis point in
  0. < height && height < length && across < radius_a +. (slope *. height)

(* Whether a point is in the inside of a shape, by what a shape is. *)
let rec holds_point shape point =
  match (shape : Shape.t) with
  | Sphere s -> Vec3.length (Vec3.sub point (Sphere.centre s)) < s.radius
  | Plane p -> Vec3.dot (Vec3.sub point p.point) (p.normal :> Vec3.t) < 0.
  | Box { low; high } ->
      low.x < point.x && point.x < high.x && low.y < point.y
      && point.y < high.y && low.z < point.z && point.z < high.z
  | Cylinder c -> frustum_holds (c :> Frustum.t) point
  | Cone c -> frustum_holds (c :> Frustum.t) point
  | Torus { centre; axis; ring; tube } ->
      let height, across = from_axis centre axis point in
      Float.hypot (across -. ring) height < tube
  | Disc _ | Triangle _ | Quad _ -> false
  | Mesh m -> Mesh.depth m point > 0.
  | Placed p -> holds_point p.own (Affine.point p.back point)
  | Solid s -> tree_holds s.members point s.tree

and tree_holds members point : int Solid.tree -> bool = function
  | Member m -> holds_point members.(m) point
  | Combined (operation, parts) -> (
      let holds = List.map (tree_holds members point) parts in
      match operation with
      | Union -> List.mem true holds
      | Intersection -> not (List.mem false holds)
      | Difference -> List.hd holds && not (List.mem true (List.tl holds)))

(* Far enough from every crossing for rounding not to decide. *)
let between_crossings ts =
  let rec middles = function
    | a :: (b :: _ as rest) ->
        if b -. a > 1e-4 then ((a +. b) /. 2.) :: middles rest
        else middles rest
    | [ last ] -> [ last +. 1. ]
    | [] -> [ 0. ]
  in
  match ts with [] -> [ 0. ] | first :: _ -> (first -. 1.) :: middles ts

let inside_by_turns =
  Property.holds "crossings lead in and out of the inside" ~count:5000
    (shapes_and_rays Generate.everyday) (fun (shape, ray) ->
      let found = Crossings.create () in
      Shape.crossings_raw shape (Ray.to_raw ray) found;
      let crossings = Crossings.to_list found in
      let is_inside t =
        List.fold_left
          (fun inside (c : Crossings.crossing) ->
            if c.t < t then c.enters else inside)
          found.starts_inside crossings
      in
      List.for_all
        (fun t -> is_inside t = holds_point shape (Ray.at ray t))
        (between_crossings (Shape.intersections shape ray)))

let pairs =
  Property.holds "a solid's crossings come in pairs, in and out" ~count:5000
    QCheck2.Gen.(
      pair (Generate.solid Generate.extreme) (Generate.ray Generate.extreme))
    (fun (solid, ray) ->
      let rec are_pairs last = function
        | [] -> true
        | (a, _, true) :: (b, _, false) :: rest ->
            last <= a && a <= b && are_pairs b rest
        | _ -> false
      in
      are_pairs neg_infinity (Ask.crossings solid ray))

(* Rays that start near the shape, as far as it has a place. *)
let hits_of number =
  QCheck2.Gen.(pair (Generate.shape number) (Generate.ray number))

let print =
  Property.show (fun ppf (shape, ray) ->
      Format.fprintf ppf "%a@.%a" Shape.pp shape Ray.pp ray)

let hits shape ray =
  List.map
    (fun (t, part, enters) -> (Ask.spot ~part shape ~reach:t ray, t, enters))
    (Ask.crossings shape ray)

let settled_is_met =
  Property.holds "what is settled lies on the ray and on the shape" ~count:5000
    ~print (hits_of Generate.everyday) (fun (shape, ray) ->
      let lies (spot, t, _) =
        let point = Spot.point spot in
        Vec3.length (Vec3.sub point (Ray.at ray t)) < 1e-6
        &&
        let depth = Shape.depth shape point in
        depth = neg_infinity || abs_float depth < 1e-12
      in
      List.for_all lies (hits shape ray))

let normal_is_outward =
  Property.holds "normals have length 1 and point outwards" ~count:5000 ~print
    (hits_of Generate.everyday) (fun (shape, ray) ->
      let d = (Ray.direction ray :> Vec3.t) in
      let is_outward ((spot : Spot.t), _, enters) =
        let n = Vec3.make spot.nx spot.ny spot.nz in
        let along = Vec3.dot n d in
        abs_float (Vec3.length n -. 1.) < 1e-14
        && (Shape.depth shape Vec3.zero = neg_infinity
           || if enters then along < 1e-6 else along > -1e-6)
      in
      List.for_all is_outward (hits shape ray))

(* Grazing rays aside, where rounding decides. *)
let moved_together =
  Property.holds "shape and ray moved together meet as before" ~count:5000
    ~print:(fun (a, _) -> print a)
    QCheck2.Gen.(
      pair (hits_of Generate.everyday) (Generate.change Generate.everyday))
    (fun ((shape, ray), change) ->
      let affine = Change.affine change in
      let way = Affine.vector affine (Ray.direction ray :> Vec3.t) in
      let moved_ray = Build.ray (Affine.point affine (Ray.origin ray)) way
      and factor = Vec3.length way in
      let before = Ask.crossings shape ray
      and after = Ask.crossings (Shape.transformed change shape) moved_ray in
      let near (a, _, enters) (b, _, enters') =
        abs_float ((a *. factor) -. b) < 1e-5 *. (1. +. abs_float b)
        && enters = enters'
      in
      let rec is_graze = function
        | (a, _, _) :: ((b, _, _) :: _ as rest) ->
            b -. a < 1e-4 || is_graze rest
        | _ -> false
      in
      is_graze before || is_graze after
      || List.length before = List.length after
         && List.for_all2 near before after)

let suite =
  ( "Shape",
    [
      Alcotest.test_case "sphere" `Quick test_sphere;
      Alcotest.test_case "plane" `Quick test_plane;
      Alcotest.test_case "depth" `Quick test_depth;
      Alcotest.test_case "place" `Quick test_place;
      Alcotest.test_case "equal" `Quick test_equal;
      Alcotest.test_case "parameters" `Quick test_parameters;
      Alcotest.test_case "box" `Quick test_box;
      box_holds;
      box_of_sphere;
      nearest_is_least;
      inside_by_turns;
      pairs;
      settled_is_met;
      normal_is_outward;
      moved_together;
    ] )
