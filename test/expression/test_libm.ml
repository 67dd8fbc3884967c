(* Whatever the platform's own functions are, they are right to about a unit in
   the last place; so a million results may differ by two. *)

open Raylab_expression

let count = 1_000_000
let radian = 0x1.1df46a2529d39p-6
let radian_low = 0x1.5c1d8becdd291p-62
let degree = 0x1.ca5dc1a63c1f8p+5
let degree_low = -0x1.1e7ab456405f9p-49

(* The product with a constant of twice the digits, as two doubles. *)
let times_high x c = x *. c
let times_low x c c_low = Float.fma x c (-.(x *. c)) +. (x *. c_low)

let check name random f high low =
  let state = Random.State.make [| 14 |] in
  for _ = 1 to count do
    let x = random state in
    let got = f x in
    let high = high x in
    let error = Ulp.error got ~high ~low:(low x high) in
    if not (error <= 2.) then
      Alcotest.failf "%s %h: %h and %h differ by %.3f" name x got high error
  done

let uniform a b state = a +. Random.State.float state (b -. a)
let angle = uniform (-720.) 720.

(* f of the degrees, by its value at the nearest radians and its slope there *)
let check_degrees name f libm slope =
  let high x = libm (times_high x radian) in
  let low x _ = slope (x *. radian) *. times_low x radian radian_low in
  check name angle f high low

let test_degrees () =
  check_degrees "sin" Degrees.sin sin cos;
  check_degrees "cos" Degrees.cos cos (fun t -> -.sin t);
  check_degrees "tan" Degrees.tan tan (fun t -> 1. +. (tan t *. tan t))

let check_arc name random f libm =
  let high x = times_high (libm x) degree in
  let low x _ = times_low (libm x) degree degree_low in
  check name random f high low

let test_arc () =
  let unit = uniform (-1.) 1. in
  check_arc "asin" unit Arc.asin asin;
  check_arc "acos" unit Arc.acos acos;
  check_arc "atan" (uniform (-10.) 10.) Arc.atan atan;
  let libm x = Stdlib.atan2 x (x +. 1.) in
  check_arc "atan2" (uniform (-10.) 10.) (fun x -> Arc.atan2 x (x +. 1.)) libm

let test_power () =
  let none _ _ = 0. in
  check "exp" (uniform (-708.) 709.) Power.exp exp none;
  check "exp" (uniform (-1.) 1.) Power.exp exp none;
  check "log" (uniform 0. 10.) Power.log log none;
  let wide state = exp (uniform (-700.) 700. state) in
  check "log" wide Power.log log none;
  let f x = Power.pow x (x -. 3.) and libm x = x ** (x -. 3.) in
  check "pow" (uniform 0. 100.) f libm none

let suite =
  ( "Libm",
    [
      Alcotest.test_case "degrees" `Quick test_degrees;
      Alcotest.test_case "arc" `Quick test_arc;
      Alcotest.test_case "power" `Quick test_power;
    ] )
