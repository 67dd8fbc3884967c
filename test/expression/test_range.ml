open Raylab_expression
open Test_support

let check = Alcotest.check Same.number

let test_modulo () =
  List.iter
    (fun (x, d, expected) ->
      check (Printf.sprintf "%g mod %g" x d) expected (Range.modulo x d))
    [
      (7., 3., 1.);
      (-7., 3., 2.);
      (7., -3., -2.);
      (-7., -3., -1.);
      (6., 3., 0.);
      (-6., 3., 0.);
      (-0.25, 1., 0.75);
      (370.5, 360., 10.5);
      (* 0.1 is a little more than a tenth, 10 times that more than 1 *)
      (1., 0.1, 0.09999999999999995);
      (1e22, 360., 280.);
      (-1e-20, 360., 0.);
      (5., 0., nan);
      (infinity, 3., nan);
      (nan, 3., nan);
    ];
  Alcotest.(check bool) "no -0" false (Float.sign_bit (Range.modulo (-6.) 3.))

let in_range =
  let pair = QCheck2.Gen.pair Generate.extreme Generate.extreme in
  Property.holds ~count:20_000 "modulo is in its range" pair (fun (x, d) ->
      let rest = Range.modulo x d in
      if d > 0. then rest >= 0. && rest < d
      else if d < 0. then rest <= 0. && rest > d
      else Float.is_nan rest)

let test_clamp () =
  check "below" 1. (Range.clamp 0. 1. 2.);
  check "above" 2. (Range.clamp 3. 1. 2.);
  check "between" 1.5 (Range.clamp 1.5 1. 2.);
  check "NaN" nan (Range.clamp nan 1. 2.)

let test_mix () =
  check "all of a" 0.1 (Range.mix 0.1 0.7 0.);
  check "all of b" 0.7 (Range.mix 0.1 0.7 1.);
  check "a quarter of b" 2.5 (Range.mix 2. 4. 0.25);
  check "beyond" 6. (Range.mix 2. 4. 2.)

(* 3/16 - 2/64 = 10/64 *)
let test_smoothstep () =
  check "before" 0. (Range.smoothstep 2. 4. 1.);
  check "a quarter" 0.15625 (Range.smoothstep 2. 4. 2.5);
  check "the middle" 0.5 (Range.smoothstep 2. 4. 3.);
  check "after" 1. (Range.smoothstep 2. 4. 5.);
  check "down, a quarter" 0.15625 (Range.smoothstep 4. 2. 3.5);
  check "down, after" 1. (Range.smoothstep 4. 2. 1.);
  check "a step, before" 0. (Range.smoothstep 2. 2. 1.99);
  check "a step, there" 1. (Range.smoothstep 2. 2. 2.)

let suite =
  ( "Range",
    [
      Alcotest.test_case "modulo" `Quick test_modulo;
      in_range;
      Alcotest.test_case "clamp" `Quick test_clamp;
      Alcotest.test_case "mix" `Quick test_mix;
      Alcotest.test_case "smoothstep" `Quick test_smoothstep;
    ] )
