open Raylab_geometry
open Test_support
open Build

let floor = Plane.make ~point:(v 7. (-1.) 3.) ~normal:(dir 0. 1. 0.)
let check_all = Alcotest.(check (list (Same.near 1e-14)))
let check_nearest = Alcotest.check (Same.near 1e-14)

(* From height 3 the floor at -1 is 4 below; along (3, -4, 0) / 5 the way is
   4 / 0.8 = 5. *)
let test_ahead () =
  let oblique = ray (v 0. 3. 0.) (v 3. (-4.) 0.) in
  check_all "straight down" [ 4. ]
    (Plane.intersections floor (ray (v 0. 3. 0.) (v 0. (-1.) 0.)));
  check_all "obliquely" [ 5. ] (Plane.intersections floor oblique);
  check_nearest "nearest" 5. (Plane.nearest floor oblique);
  check_nearest "from below" 2.
    (Plane.nearest floor (ray (v 0. (-3.) 0.) (v 0. 1. 0.)))

let test_behind () =
  let up = ray (v 0. 3. 0.) (v 0. 1. 0.) in
  check_all "negative" [ -4. ] (Plane.intersections floor up);
  check_nearest "none" infinity (Plane.nearest floor up)

let test_parallel () =
  let none what origin direction =
    check_all what [] (Plane.intersections floor (ray origin direction));
    check_nearest what infinity (Plane.nearest floor (ray origin direction))
  in
  none "above" (v 0. 3. 0.) (v 1. 0. 0.);
  none "below" (v 0. (-3.) 0.) (v 1. 0. 1.);
  none "in the plane" (v 0. (-1.) 0.) (v 1. 0. 0.)

let test_from_it () =
  let away = ray (v 0. (-1.) 0.) (v 0. 1. 0.) in
  check_all "t = 0 is an intersection" [ 0. ] (Plane.intersections floor away);
  check_nearest "but no hit" infinity (Plane.nearest floor away)

(* Falling by 1 in 1e8: the floor, 1 below, is met after sqrt (1e16 + 1), which
   is 1e8 and half of 1e-8. *)
let test_grazing () =
  check_nearest "far away" 1e8
    (Plane.nearest
       (Plane.make ~point:(v 0. (-1.) 0.) ~normal:(dir 0. 1. 0.))
       (ray Vec3.zero (v 1e8 (-1.) 0.)))

let test_either_normal () =
  let ceiling = Plane.make ~point:(v 0. (-1.) 0.) ~normal:(dir 0. (-1.) 0.) in
  check_nearest "the normal's side makes no difference" 4.
    (Plane.nearest ceiling (ray (v 0. 3. 0.) (v 0. (-1.) 0.)))

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
        (Plane.intersections (Plane.make ~point ~normal) ray))

let finite =
  Property.holds "finite, whatever the size" ~count:5000
    (planes_and_rays Generate.extreme) (fun (point, normal, ray) ->
      match Plane.intersections (Plane.make ~point ~normal) ray with
      | [] -> true
      | [ t ] -> Float.is_finite t
      | _ -> false)

let suite =
  ( "Plane",
    [
      Alcotest.test_case "ahead" `Quick test_ahead;
      Alcotest.test_case "behind" `Quick test_behind;
      Alcotest.test_case "parallel" `Quick test_parallel;
      Alcotest.test_case "from a point of it" `Quick test_from_it;
      Alcotest.test_case "grazing" `Quick test_grazing;
      Alcotest.test_case "either normal" `Quick test_either_normal;
      Alcotest.test_case "invalid" `Quick test_invalid;
      on_it;
      finite;
    ] )
