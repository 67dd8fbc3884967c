open Raylab_expression
open Test_support

let check = Alcotest.check Same.number

let test_exact () =
  List.iter
    (fun (sine, angle) ->
      check "asin" angle (Arc.asin sine);
      check "acos" (90. -. angle) (Arc.acos sine))
    [ (0., 0.); (-0., 0.); (0.5, 30.); (-0.5, -30.); (1., 90.); (-1., -90.) ];
  List.iter
    (fun (tangent, angle) -> check "atan" angle (Arc.atan tangent))
    [ (0., 0.); (1., 45.); (-1., -45.); (infinity, 90.); (neg_infinity, -90.) ]

let test_bounds () =
  let beyond = 1. +. 1e-9 and far = 1. +. 1.1e-9 in
  check "asin, a little beyond" 90. (Arc.asin beyond);
  check "asin, a little beyond" (-90.) (Arc.asin (-.beyond));
  check "acos, a little beyond" 0. (Arc.acos beyond);
  check "acos, a little beyond" 180. (Arc.acos (-.beyond));
  List.iter
    (fun x ->
      check "asin" nan (Arc.asin x);
      check "acos" nan (Arc.acos x))
    [ far; -.far; infinity; nan ]

(* The eight directions of a compass, of any size; zeros have no sign. *)
let test_around () =
  let around r =
    List.iter
      (fun (y, x, angle) -> check "atan2" angle (Arc.atan2 (y *. r) (x *. r)))
      [
        (0., 1., 0.);
        (1., 1., 45.);
        (1., 0., 90.);
        (1., -0., 90.);
        (1., -1., 135.);
        (0., -1., 180.);
        (-0., -1., 180.);
        (-1., -1., -135.);
        (-1., 0., -90.);
        (-1., 1., -45.);
        (0., 0., 0.);
        (-0., -0., 0.);
      ]
  in
  List.iter around [ 1.; 3e-5; 1e300; max_float; 1e-300; 5e-324 ]

let test_not_finite () =
  check "straight on" 0. (Arc.atan2 1e308 infinity);
  check "back" (-180.) (Arc.atan2 (-1e308) neg_infinity);
  check "up" 90. (Arc.atan2 infinity (-1e308));
  check "both" nan (Arc.atan2 infinity infinity);
  check "y" nan (Arc.atan2 nan 1.);
  check "x" nan (Arc.atan2 1. nan);
  check "atan" nan (Arc.atan nan)

(* The quotient, which is all that there is of the smallest angles. *)
let test_tiny () =
  check "1e-320 / 1e-10"
    (Arc.atan2 (1e-310 /. 1e-10) 1.)
    (Arc.atan2 1e-310 1e-10);
  check "beyond doubles" 0. (Arc.atan2 5e-324 1e300);
  check "and almost a half turn" 180. (Arc.atan2 5e-324 (-1e300));
  check "with its sign" (-180.) (Arc.atan2 (-5e-324) (-1e300))

let degrees = QCheck2.Gen.float_range (-89.) 89.

let back_and_forth =
  Property.holds ~count:20_000 "arcs of degrees" degrees (fun x ->
      let near y = abs_float (y -. x) <= 1e-12 in
      near (Arc.asin (Degrees.sin x))
      && near (Arc.atan (Degrees.tan x))
      && near (90. -. Arc.acos (Degrees.sin x))
      && near (Arc.atan2 (Degrees.sin x) (Degrees.cos x)))

let suite =
  ( "Arc",
    [
      Alcotest.test_case "exact values" `Quick test_exact;
      Alcotest.test_case "bounds" `Quick test_bounds;
      Alcotest.test_case "around" `Quick test_around;
      Alcotest.test_case "not finite" `Quick test_not_finite;
      Alcotest.test_case "tiny angles" `Quick test_tiny;
      back_and_forth;
    ] )
