open Raylab_geometry
open Test_support
open Build

let ball ?(radius = 1.) x y z = Shape.sphere ~centre:(v x y z) ~radius
let half_space normal = Shape.plane ~point:Vec3.zero ~normal
let member shape = Solid.Member shape
let combined operation shapes = Solid.Combined (operation, shapes)

let solid ?(tolerance = 1e-5) tree =
  Shape.with_tolerance tolerance (Shape.solid tree)

let of_shapes operation shapes =
  solid (combined operation (List.map member shapes))

let crosses what expected shape origin direction =
  Alcotest.(check (list (pair (Same.near 1e-12) bool)))
    what expected
    (List.map
       (fun (t, _, enters) -> (t, enters))
       (Ask.crossings shape (ray origin direction)))

let met shape origin direction =
  match Shape.nearest shape (ray origin direction) with
  | None -> None
  | Some (t, part) -> (
      match (shape : Shape.t) with
      | Solid s -> Some (t, Solid.member_of s ~part)
      | _ -> None)

let check_met what expected shape origin direction =
  Alcotest.(check (option (pair (Same.near 1e-12) int)))
    what expected
    (met shape origin direction)

(* {1 By hand} *)

let x = v 1. 0. 0.

(* Two balls of radius 1 around -0.8 and 0.8: along x from -0.2 to 0.2. *)
let test_lens () =
  let lens = of_shapes Intersection [ ball (-0.8) 0. 0.; ball 0.8 0. 0. ] in
  crosses "through it" [ (4.8, true); (5.2, false) ] lens (v (-5.) 0. 0.) x;
  crosses "above it" [] lens (v (-5.) 0.7 0.) x;
  check_met "it is the second ball that is met"
    (Some (4.8, 1))
    lens (v (-5.) 0. 0.) x

let test_hemisphere () =
  let half = of_shapes Intersection [ ball 0. 0. 0.; half_space x ] in
  crosses "in by the ball, out by the plane"
    [ (4., true); (5., false) ]
    half (v (-5.) 0. 0.) x;
  let spot = Ask.spot half ~part:1 ~reach:5. (ray (v (-5.) 0. 0.) x) in
  Alcotest.check Same.vec3 "outward" x (Spot.normal spot :> Vec3.t);
  let other = of_shapes Difference [ ball 0. 0. 0.; half_space x ] in
  crosses "the other half" [ (5., true); (6., false) ] other (v (-5.) 0. 0.) x;
  let spot = Ask.spot other ~part:1 ~reach:5. (ray (v (-5.) 0. 0.) x) in
  Alcotest.check Same.vec3 "turned around" (v (-1.) 0. 0.)
    (Spot.normal spot :> Vec3.t)

let test_shell () =
  let shell =
    of_shapes Difference [ ball ~radius:2. 0. 0. 0.; ball 0. 0. 0. ]
  in
  crosses "through it"
    [ (3., true); (4., false); (6., true); (7., false) ]
    shell (v (-5.) 0. 0.) x;
  check_met "the eye in the hollow" (Some (1., 1)) shell Vec3.zero x;
  check_met "the eye in the wall" (Some (0.5, 0)) shell (v 1.5 0. 0.) x;
  Alcotest.check (Same.near 1e-12) "deep in the wall" 0.5
    (Shape.depth shell (v 1.5 0. 0.));
  Alcotest.check (Same.near 1e-12) "in the hollow" (-1.)
    (Shape.depth shell Vec3.zero)

let test_coinciding () =
  let a = ball 0. 0. 0. and b = ball 1e-7 0. 0. in
  crosses "no skin" [] (of_shapes Difference [ a; b ]) (v (-5.) 0.1 0.) x;
  check_met "the first stands, also if it is behind"
    (Some (4., 0))
    (of_shapes Union [ a; ball (-1e-7) 0. 0. ])
    (v (-5.) 0. 0.) x;
  let floor = half_space x and beyond = half_space (v (-1.) 0. 0.) in
  crosses "no gap" [] (of_shapes Union [ floor; beyond ]) (v (-5.) 0. 0.) x;
  let far = of_shapes Difference [ a; ball 1e-3 0. 0. ] in
  crosses "a thin one stays"
    [ (4., true); (4.001, false) ]
    far (v (-5.) 0. 0.) x

let test_nested () =
  let cut =
    solid
      (combined Difference
         [
           combined Union [ member (ball 0. 0. 0.); member (ball 1.5 0. 0.) ];
           combined Difference
             [ member (ball 0. 0. 0.); member (ball ~radius:0.5 0. 0. 0.) ];
         ])
  in
  crosses "a core, and the other ball"
    [ (4.5, true); (5.5, false); (6., true); (7.5, false) ]
    cut (v (-5.) 0. 0.) x;
  Expect.invalid "of nothing" (fun () ->
      Shape.solid (combined Intersection []));
  Alcotest.(check bool)
    "an empty union" true
    (Ask.crossings (Shape.solid (combined Union [])) (ray Vec3.zero x) = [])

(* {1 Laws} *)

(* The parts of the line inside of a shape, whose ends are not near others. *)
let inside shape r =
  let found = Crossings.create () in
  Shape.crossings_raw shape (Ray.to_raw r) found;
  (found.starts_inside, List.map (fun (t, _, _) -> t) (Ask.crossings shape r))

let same (starts, ts) (starts', ts') =
  let near a b = abs_float (a -. b) <= 1e-9 *. (1. +. abs_float a) in
  starts = starts' && List.equal near ts ts'

let law name make =
  Property.holds name ~count:1000
    QCheck2.Gen.(
      pair
        (triple
           (Generate.solid_shape Generate.everyday)
           (Generate.solid_shape Generate.everyday)
           (Generate.solid_shape Generate.everyday))
        (Generate.ray Generate.everyday))
    (fun ((a, b, c), r) ->
      let one, other = make (member a) (member b) (member c) in
      let exactly tree = inside (Shape.solid tree) r in
      same (exactly one) (exactly other))

let everything =
  combined Union [ member (half_space x); member (half_space (v (-1.) 0. 0.)) ]

let without a = combined Difference [ everything; a ]
let union a b = combined Union [ a; b ]
let intersection a b = combined Intersection [ a; b ]
let difference a b = combined Difference [ a; b ]
let nothing = combined Union []

let laws =
  [
    law "union commutes" (fun a b _ -> (union a b, union b a));
    law "intersection commutes" (fun a b _ ->
        (intersection a b, intersection b a));
    law "union and intersection distribute" (fun a b c ->
        ( intersection a (union b c),
          union (intersection a b) (intersection a c) ));
    law "De Morgan" (fun a b _ ->
        (without (union a b), intersection (without a) (without b)));
    law "A - B is A and not B" (fun a b _ ->
        (difference a b, intersection a (without b)));
    law "A - A is nothing" (fun a _ _ -> (difference a a, nothing));
    law "A + A is A" (fun a _ _ -> (union a a, union a nothing));
  ]

let suite =
  ( "Solid",
    [
      Alcotest.test_case "lens" `Quick test_lens;
      Alcotest.test_case "hemisphere" `Quick test_hemisphere;
      Alcotest.test_case "shell" `Quick test_shell;
      Alcotest.test_case "coinciding" `Quick test_coinciding;
      Alcotest.test_case "nested" `Quick test_nested;
    ]
    @ laws )
