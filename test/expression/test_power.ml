open Raylab_expression
open Test_support

let check = Alcotest.check Same.number

let test_exp () =
  check "of 0" 1. (Power.exp 0.);
  check "of 1" 2.718281828459045 (Power.exp 1.);
  check "too large" infinity (Power.exp 709.79);
  check "almost" 1.7928227943945155e308 (Power.exp 709.78);
  check "too small" 0. (Power.exp (-745.14));
  check "almost" 5e-324 (Power.exp (-745.13));
  check "of infinity" infinity (Power.exp infinity);
  check "of -infinity" 0. (Power.exp neg_infinity);
  check "of NaN" nan (Power.exp nan)

let test_log () =
  check "of 1" 0. (Power.log 1.);
  check "of 2" 0.6931471805599453 (Power.log 2.);
  check "of 10" 2.302585092994046 (Power.log 10.);
  check "of 0" neg_infinity (Power.log 0.);
  check "of -0" neg_infinity (Power.log (-0.));
  check "of infinity" infinity (Power.log infinity);
  List.iter
    (fun x -> check "none" nan (Power.log x))
    [ -1.; -5e-324; neg_infinity; nan ]

(* Powers that are doubles are exactly right. *)
let test_exact_powers () =
  for base = 2 to 9 do
    let power = ref 1. in
    for exponent = 0 to 16 do
      (* 9^16 < 2^53 *)
      let name = Printf.sprintf "%d^%d" base exponent in
      check name !power (Power.pow (float base) (float exponent));
      power := !power *. float base
    done
  done;
  for e = -1074 to 1023 do
    check "2^e" (ldexp 1. e) (Power.pow 2. (float e))
  done;
  check "a root" 1.5 (Power.pow 2.25 0.5);
  check "a cube of a root" 27. (Power.pow 9. 1.5);
  check "1 / 8" 0.125 (Power.pow 2. (-3.));
  check "one percent" 0.01 (Power.pow 10. (-2.))

let test_signs () =
  check "(-2)^3" (-8.) (Power.pow (-2.) 3.);
  check "(-2)^2" 4. (Power.pow (-2.) 2.);
  check "(-2)^-3" (-0.125) (Power.pow (-2.) (-3.));
  check "(-1)^large" 1. (Power.pow (-1.) 1e300);
  check "(-1)^(2^53 - 1)" (-1.) (Power.pow (-1.) 9007199254740991.);
  check "no whole number" nan (Power.pow (-8.) (1. /. 3.));
  check "too large" neg_infinity (Power.pow (-10.) 309.)

let test_zero () =
  List.iter
    (fun x -> check "x^0" 1. (Power.pow x 0.))
    [ 0.; -0.; 2.; -2.; max_float; infinity; nan ];
  check "0^2" 0. (Power.pow 0. 2.);
  check "0^0.5" 0. (Power.pow 0. 0.5);
  check "0^-1" infinity (Power.pow 0. (-1.));
  check "(-0)^-1" infinity (Power.pow (-0.) (-1.))

let test_ends () =
  check "too large" infinity (Power.pow 10. 308.3);
  check "too small" 0. (Power.pow 10. (-323.7));
  check "much" infinity (Power.pow 1.0000000000000002 1e300);
  check "little" 0. (Power.pow 0.9999999999999999 1e300);
  check "NaN^2" nan (Power.pow nan 2.);
  check "NaN^3" nan (Power.pow nan 3.);
  check "2^NaN" nan (Power.pow 2. nan);
  check "0^NaN" nan (Power.pow 0. nan);
  check "1^NaN" 1. (Power.pow 1. nan);
  check "infinity^0.5" infinity (Power.pow infinity 0.5);
  check "infinity^-1" 0. (Power.pow infinity (-1.));
  check "2^-infinity" 0. (Power.pow 2. neg_infinity)

let suite =
  ( "Power",
    [
      Alcotest.test_case "exp" `Quick test_exp;
      Alcotest.test_case "log" `Quick test_log;
      Alcotest.test_case "exact powers" `Quick test_exact_powers;
      Alcotest.test_case "signs" `Quick test_signs;
      Alcotest.test_case "zero" `Quick test_zero;
      Alcotest.test_case "ends" `Quick test_ends;
    ] )
