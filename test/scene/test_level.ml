open Raylab_scene
open Test_support

let check what expected v =
  Alcotest.(check int) what expected (Level.of_channel v)

let test_clamped () =
  check "0" 0 0.;
  check "-0" 0 (-0.);
  check "1" 255 1.;
  check "negative" 0 (-0.1);
  check "above 1" 255 1.5;
  check "largest" 255 max_float;
  check "infinity" 255 infinity;
  check "-infinity" 0 neg_infinity;
  check "NaN" 0 nan;
  check "-NaN" 0 (-.nan);
  check "smallest" 0 5e-324;
  check "below 1" 255 (Float.pred 1.)

(* 0.25 * 255 = 63.75 and 0.75 * 255 = 191.25; 0.1 * 255 = 25.5 is a tie in
   decimals, but 0.1 as a double is a little more than a tenth, and the product
   is rounded: see [test_ties]. *)
let test_nearest () =
  check "63.75" 64 0.25;
  check "191.25" 191 0.75;
  check "0.4" 0 (0.4 /. 255.);
  check "0.6" 1 (0.6 /. 255.);
  check "254.4" 254 (254.4 /. 255.)

(* 0.5 * 255 = 127.5 exactly, and goes up, to the even 128. For other ties the
   quotient is rounded; only where the product comes back to the tie exactly is
   it one, and of those there are about as many that go down as up. *)
let test_ties () =
  check "127.5" 128 0.5;
  let check_tie k =
    let v = (float_of_int k +. 0.5) /. 255. in
    if v *. 255. = float_of_int k +. 0.5 then (
      let even = if k mod 2 = 0 then k else k + 1 in
      check (Printf.sprintf "%d.5" k) even v;
      [ k mod 2 ])
    else []
  in
  let parities = List.concat (List.init 255 check_tie) in
  let count p = List.length (List.filter (Int.equal p) parities) in
  Alcotest.(check bool) "some go down" true (count 0 > 50);
  Alcotest.(check bool) "some go up" true (count 1 > 50)

let every_level =
  Alcotest.test_case "every level is its own" `Quick (fun () ->
      for k = 0 to 255 do
        check (string_of_int k) k (float_of_int k /. 255.)
      done)

let suite =
  ( "Level",
    [
      Alcotest.test_case "clamped" `Quick test_clamped;
      Alcotest.test_case "nearest" `Quick test_nearest;
      Alcotest.test_case "ties to even" `Quick test_ties;
      every_level;
      Property.holds "brighter is never darker"
        QCheck2.Gen.(pair Generate.extreme Generate.extreme)
        (fun (a, b) ->
          Level.of_channel (Float.min a b) <= Level.of_channel (Float.max a b));
    ] )
