open Raylab_expression
open Test_support

let check = Alcotest.check Same.number

(* (1 + 2^-27)^2 = 1 + 2^-26 + 2^-54, whose last part is lost in the product,
   and would be what is left if there were only one rounding. *)
let test_two_roundings () =
  let x = 1. +. 0x1p-27 in
  let square = 1. +. 0x1p-26 in
  check "mul_add" 0. (Exact.mul_add x x (-.square));
  check "sub_mul" 0. (Exact.sub_mul square x x)

let test_head () =
  check "few bits" 0x1.ffffffp0 (Exact.head 0x1.ffffffp0);
  check "26 bits" 0x1.000001p0 (Exact.head 0x1.0000010000001p0);
  check "-0" 0. (Exact.head (-0.))

let test_nearest () =
  List.iter
    (fun (x, whole) -> check (string_of_float x) whole (Exact.nearest x))
    [
      (0.5, 0.);
      (1.5, 2.);
      (2.5, 2.);
      (-1.5, -2.);
      (-0.49, 0.);
      (1e15 +. 0.625, 1e15 +. 1.);
      (-1e15 -. 0.625, -1e15 -. 1.);
    ]

let test_scale () =
  check "up" 0x1.8p1023 (Exact.scale 1.5 1023);
  check "down" 0x1p-1074 (Exact.scale 1. (-1074));
  check "far up" 0x1.8p1000 (Exact.scale 0x1.8p-1000 2000);
  check "rounded once, not to 2.5 first" 0x2p-1074
    (Exact.scale 0x2.7ffffffffffffp0 (-1074));
  check "too large" infinity (Exact.scale 1. 1024);
  check "too small" 0. (Exact.scale 1. (-1076))

(* All powers of two, and the doubles just below the next one. *)
let test_exponent () =
  for e = -1074 to 1023 do
    let power = ldexp 1. e in
    Alcotest.(check int) "of a power" e (Exact.exponent power);
    check "the power" power (Exact.scale 1. e);
    let below = Float.pred (2. *. power) in
    Alcotest.(check int) "of the last" e (Exact.exponent below)
  done

let suite =
  ( "Exact",
    [
      Alcotest.test_case "two roundings" `Quick test_two_roundings;
      Alcotest.test_case "head" `Quick test_head;
      Alcotest.test_case "nearest" `Quick test_nearest;
      Alcotest.test_case "scale" `Quick test_scale;
      Alcotest.test_case "exponent" `Quick test_exponent;
    ] )
