open Raylab_expression
open Test_support

let check = Alcotest.check Same.number

(* Hits of a million numbers in a thousand equal parts of [0, 1): chi squared
   has the mean 999 and the standard deviation 45 if they are random. *)
let test_even (name, number) =
  let test () =
    let hits = Array.make 1000 0 in
    for i = 0 to 999_999 do
      let part = int_of_float (1000. *. Hash.random (number (float i))) in
      hits.(part) <- hits.(part) + 1
    done;
    let off hits = float ((hits - 1000) * (hits - 1000)) /. 1000. in
    let chi = Array.fold_left (fun sum hits -> sum +. off hits) 0. hits in
    Alcotest.(check (float 200.)) "chi squared" 999. chi
  in
  Alcotest.test_case name `Quick test

let evenly =
  List.map test_even
    [
      ("whole numbers", fun i -> i);
      ("negative numbers", fun i -> -.i);
      ("tenths", fun i -> i /. 10.);
      ("large numbers", fun i -> i *. 1e10);
      ("the smallest numbers", fun i -> i *. 5e-324);
      ("neighbours", fun i -> 1. +. (i *. epsilon_float));
    ]

(* The mean product of what follows each other, 1/4 if there is no relation; of
   a million it is within 0.0003 of that in two cases of three. *)
let test_followers () =
  let sum = ref 0. in
  for i = 0 to 999_999 do
    sum := !sum +. (Hash.random (float i) *. Hash.random (float (i + 1)))
  done;
  Alcotest.(check (float 0.0015)) "correlation" 0.25 (!sum /. 1e6)

(* Each bit of the argument turns over each of the result in half of the cases:
   of 10,000, within 250 is five standard deviations. *)
let test_mix () =
  let state = Random.State.make [| 30 |] in
  for i = 0 to 29 do
    let turned = Array.make 30 0 in
    for _ = 1 to 10_000 do
      let h = Random.State.bits state in
      let change = Hash.mix h lxor Hash.mix (h lxor (1 lsl i)) in
      Array.iteri (fun j n -> turned.(j) <- n + ((change lsr j) land 1)) turned
    done;
    let half n = abs (n - 5000) <= 250 in
    Alcotest.(check bool) "half of them" true (Array.for_all half turned)
  done

let in_range =
  Property.holds ~count:20_000 "from 0 to 1" Generate.extreme (fun k ->
      let x = Hash.random k in
      x >= 0. && x < 1. && x = Hash.random k)

let test_special () =
  check "one zero" (Hash.random 0.) (Hash.random (-0.));
  let differ name a b =
    Alcotest.(check bool) name true (Hash.random a <> Hash.random b)
  in
  differ "a sign" 1. (-1.);
  differ "an exponent" 1. 2.;
  differ "the last bit" 1. (Float.succ 1.);
  differ "the ends" max_float (Float.pred max_float);
  differ "0 and the next" 0. 5e-324;
  List.iter
    (fun k -> check "none" nan (Hash.random k))
    [ nan; infinity; neg_infinity ]

let suite =
  ( "Hash",
    evenly
    @ [
        Alcotest.test_case "followers" `Quick test_followers;
        Alcotest.test_case "mix" `Quick test_mix;
        in_range;
        Alcotest.test_case "special numbers" `Quick test_special;
      ] )
