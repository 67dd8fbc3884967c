open Raylab_expression
open Test_support

let check = Alcotest.check Same.number

(* The sine is rational only at these, the multiples of 30 (I. Niven). *)
let exact_sines =
  [ (0., 0.); (30., 0.5); (90., 1.); (150., 0.5); (180., 0.); (210., -0.5) ]
  @ [ (270., -1.); (330., -0.5) ]

let turns = [ 0.; 360.; -360.; 720.; -3600.; 360e9; -360e12 ]

let test_exact () =
  let at f name x expected =
    List.iter (fun turn -> check name expected (f (x +. turn))) turns
  in
  List.iter
    (fun (x, sine) ->
      at Degrees.sin "sin" x sine;
      at Degrees.cos "cos" (x -. 90.) sine)
    exact_sines;
  List.iter
    (fun (x, tangent) -> at Degrees.tan "tan" x tangent)
    [ (0., 0.); (45., 1.); (135., -1.); (180., 0.); (225., 1.); (315., -1.) ];
  at Degrees.tan "tan" 90. infinity;
  at Degrees.tan "tan" 270. infinity

(* sqrt is rounded right, and so are halves of it *)
let test_roots () =
  check "sin 45" (sqrt 0.5) (Degrees.sin 45.);
  check "cos 45" (sqrt 0.5) (Degrees.cos 45.);
  check "sin 60" (0.5 *. sqrt 3.) (Degrees.sin 60.);
  check "cos 30" (0.5 *. sqrt 3.) (Degrees.cos 30.);
  check "tan 60" (sqrt 3.) (Degrees.tan 60.)

(* 1e22 = 2^22 5^22 is 0 modulo 8, and modulo 45, since 10 = 10 * 10 (mod 45),
   10: so it is 280 modulo 360. 2^1023 is 0 modulo 8 and, since 2^12 = 1 (mod 45),
   2^3 modulo 45: 8. *)
let test_large () =
  check "1e22" (Degrees.sin 280.) (Degrees.sin 1e22);
  check "-1e22" (Degrees.cos 280.) (Degrees.cos (-1e22));
  check "2^1023" (Degrees.sin 8.) (Degrees.sin 0x1p1023);
  check "-2^1023" (Degrees.sin (-8.)) (Degrees.sin (-0x1p1023));
  (* 15 * 2^1000: 0 modulo 8; 15 * 2^4 = 240 = 15 (mod 45), so 240 *)
  check "15 * 2^1000" (Degrees.cos 240.) (Degrees.cos 0x1.ep1003)

(* fmod is exact wherever it is *)
let same_after_turns =
  Property.holds ~count:20_000 "whole turns make no difference"
    Generate.extreme (fun x ->
      let x' = Float.rem x 360. in
      Degrees.sin x = Degrees.sin x'
      && Degrees.cos x = Degrees.cos x'
      && Degrees.tan x = Degrees.tan x')

let symmetric =
  Property.holds ~count:20_000 "odd and even" Generate.extreme (fun x ->
      Degrees.sin (-.x) = -.Degrees.sin x
      && Degrees.cos (-.x) = Degrees.cos x
      && abs_float (Degrees.sin x) <= 1.
      && abs_float (Degrees.cos x) <= 1.)

let test_not_finite () =
  List.iter
    (fun x ->
      check "sin" nan (Degrees.sin x);
      check "cos" nan (Degrees.cos x);
      check "tan" nan (Degrees.tan x))
    [ nan; infinity; neg_infinity ]

let suite =
  ( "Degrees",
    [
      Alcotest.test_case "exact values" `Quick test_exact;
      Alcotest.test_case "roots" `Quick test_roots;
      Alcotest.test_case "large angles" `Quick test_large;
      same_after_turns;
      symmetric;
      Alcotest.test_case "not finite" `Quick test_not_finite;
    ] )
