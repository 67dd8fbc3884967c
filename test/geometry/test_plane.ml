open Raylab_geometry
open Test_support
open Build

let floor = Shape.plane ~point:(v 7. (-1.) 3.) ~normal:(v 0. 1. 0.)
let check_all = Alcotest.(check (list (Same.near 1e-14)))
let check_nearest = Alcotest.check (Same.near 1e-14)

(* From height 3 the floor at -1 is 4 below; along (3, -4, 0) / 5 the way is
   4 / 0.8 = 5. *)
let test_ahead () =
  let oblique = ray (v 0. 3. 0.) (v 3. (-4.) 0.) in
  check_all "straight down" [ 4. ]
    (Shape.intersections floor (ray (v 0. 3. 0.) (v 0. (-1.) 0.)));
  check_all "obliquely" [ 5. ] (Shape.intersections floor oblique);
  check_nearest "nearest" 5. (Ask.distance floor oblique);
  check_nearest "from below" 2.
    (Ask.distance floor (ray (v 0. (-3.) 0.) (v 0. 1. 0.)))

let test_behind () =
  let up = ray (v 0. 3. 0.) (v 0. 1. 0.) in
  check_all "negative" [ -4. ] (Shape.intersections floor up);
  check_nearest "none" infinity (Ask.distance floor up)

let test_parallel () =
  let none what origin direction =
    check_all what [] (Shape.intersections floor (ray origin direction));
    check_nearest what infinity (Ask.distance floor (ray origin direction))
  in
  none "above" (v 0. 3. 0.) (v 1. 0. 0.);
  none "below" (v 0. (-3.) 0.) (v 1. 0. 1.);
  none "in the plane" (v 0. (-1.) 0.) (v 1. 0. 0.)

let test_from_it () =
  let away = ray (v 0. (-1.) 0.) (v 0. 1. 0.) in
  check_all "t = 0 is an intersection" [ 0. ] (Shape.intersections floor away);
  check_nearest "but no hit" infinity (Ask.distance floor away)

(* Falling by 1 in 1e8: the floor, 1 below, is met after sqrt (1e16 + 1), which
   is 1e8 and half of 1e-8. *)
let test_grazing () =
  check_nearest "far away" 1e8
    (Ask.distance
       (Shape.plane ~point:(v 0. (-1.) 0.) ~normal:(v 0. 1. 0.))
       (ray Vec3.zero (v 1e8 (-1.) 0.)))

let test_either_normal () =
  let ceiling = Shape.plane ~point:(v 0. (-1.) 0.) ~normal:(v 0. (-1.) 0.) in
  check_nearest "the normal's side makes no difference" 4.
    (Ask.distance ceiling (ray (v 0. 3. 0.) (v 0. (-1.) 0.)))

(* Down along (3, -4, 0) / 5 from height 3, the floor is met at 5, 3 to the
   right. *)
let test_settle () =
  let spot = Ask.spot floor ~reach:5. (ray (v 0. 3. 0.) (v 3. (-4.) 0.)) in
  Alcotest.check (Same.vec3_near 1e-14) "point" (v 3. (-1.) 0.)
    (Spot.point spot);
  Alcotest.check Same.direction "normal" (dir 0. 1. 0.) (Spot.normal spot);
  Alcotest.check Same.number "no size" 0. spot.size

(* Going down one goes from the side of the normal to the inside. *)
let test_crossings () =
  let check what expected shape ray =
    Alcotest.(check (list (triple (Same.near 1e-14) int bool)))
      what expected (Ask.crossings shape ray)
  and down = ray (v 0. 3. 0.) (v 0. (-1.) 0.)
  and up = ray (v 0. 3. 0.) (v 0. 1. 0.) in
  check "in" [ (4., 0, true) ] floor down;
  check "out, behind" [ (-4., 0, false) ] floor up;
  let ceiling = Shape.plane ~point:(v 0. 9. 0.) ~normal:(v 0. (-1.) 0.) in
  check "the normal downwards" [ (6., 0, true) ] ceiling up;
  check "out" [ (-6., 0, false) ] ceiling down

(* A line along the plane is inside or outside as a whole. *)
let test_along () =
  let check what expected y =
    let found = Crossings.create () in
    Shape.crossings_raw floor (Ray.to_raw (ray (v 0. y 0.) (v 1. 0. 0.))) found;
    Alcotest.(check int) (what ^ ", crossings") 0 found.count;
    Alcotest.(check bool) what expected found.starts_inside
  in
  check "above" false 3.;
  check "in the plane" false (-1.);
  check "below" true (-3.)

let test_invalid () =
  List.iter
    (fun bad ->
      let plane x y z () =
        Plane.make ~point:(v x y z) ~normal:(dir 0. 1. 0.)
      in
      Expect.invalid "x" (plane bad 0. 0.);
      Expect.invalid "y" (plane 0. bad 0.);
      Expect.invalid "z" (plane 0. 0. bad))
    [ nan; infinity; neg_infinity ]

let planes_and_rays number =
  QCheck2.Gen.triple (Generate.vec3 number)
    (Generate.direction number)
    (Generate.ray number)

let on_it =
  Property.holds "an intersection lies on the plane" ~count:5000
    (planes_and_rays Generate.everyday) (fun (point, normal, ray) ->
      List.for_all
        (fun t ->
          let off = Vec3.sub (Ray.at ray t) point in
          (* a grazing ray meets the plane far away *)
          abs_float (Vec3.dot off (normal :> Vec3.t))
          <= 1e-12 *. (30. +. abs_float t))
        (Shape.intersections (Plane (Plane.make ~point ~normal)) ray))

let finite =
  Property.holds "finite, whatever the size" ~count:5000
    (planes_and_rays Generate.extreme) (fun (point, normal, ray) ->
      match Shape.intersections (Plane (Plane.make ~point ~normal)) ray with
      | [] -> true
      | [ t ] -> Float.is_finite t
      | _ -> false)

(* Normals of any length, for the length that is brought to 1 may miss it by
   a hair; points that rounding leaves beside the plane. *)
let own_point_is_exact =
  Property.holds "an own point across an axis is exactly on it" ~count:2000
    QCheck2.Gen.(
      quad
        (Generate.vec3 Generate.everyday)
        (int_bound 2) Generate.everyday
        (Generate.ray Generate.everyday))
    (fun (point, axis, length, ray) ->
      let across k = if k = axis then length else 0. in
      let normal = v (across 0) (across 1) (across 2) in
      let coordinate { Vec3.x; y; z } =
        match axis with 0 -> x | 1 -> y | _ -> z
      in
      Vec3.equal normal Vec3.zero
      ||
      let shape = Shape.plane ~point ~normal in
      List.for_all
        (fun reach ->
          let own = Spot.own (Ask.spot shape ~reach ray) in
          coordinate own = coordinate point)
        (Shape.intersections shape ray))

let suite =
  ( "Plane",
    [
      Alcotest.test_case "ahead" `Quick test_ahead;
      Alcotest.test_case "behind" `Quick test_behind;
      Alcotest.test_case "parallel" `Quick test_parallel;
      Alcotest.test_case "from a point of it" `Quick test_from_it;
      Alcotest.test_case "grazing" `Quick test_grazing;
      Alcotest.test_case "either normal" `Quick test_either_normal;
      Alcotest.test_case "settle" `Quick test_settle;
      Alcotest.test_case "crossings" `Quick test_crossings;
      Alcotest.test_case "along it" `Quick test_along;
      Alcotest.test_case "invalid" `Quick test_invalid;
      on_it;
      finite;
      own_point_is_exact;
    ] )
