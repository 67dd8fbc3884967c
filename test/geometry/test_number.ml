open Raylab_geometry
open Test_support

let problem = Alcotest.(option string)

let test_rules () =
  let check rule x expected =
    Alcotest.check problem (Printf.sprintf "%h" x) expected
      (Number.broken rule x)
  in
  List.iter
    (fun rule ->
      List.iter
        (fun x -> check rule x (Some "must be a finite number"))
        [ nan; infinity; neg_infinity ];
      check rule max_float None;
      check rule 5e-324 None)
    [ Number.Finite; Non_negative; Positive ];
  check Finite (-1.) None;
  check Non_negative 0. None;
  check Non_negative (-0.) None;
  check Non_negative (-5e-324) (Some "must not be negative");
  check Positive 0. (Some "must be greater than 0");
  check Positive (-0.) (Some "must be greater than 0")

let test_require () =
  Number.require Positive "a radius" 1.;
  match Number.require Positive "a radius" (-2.) with
  | () -> Alcotest.fail "a negative radius is let through"
  | exception Invalid_argument message ->
      Expect.contains "the name" ~part:"a radius" message;
      Expect.contains "the number" ~part:"-2" message;
      Expect.contains "the rule" ~part:"greater than 0" message

let test_pp () =
  let check expected x = Expect.prints expected expected Number.pp x in
  check "2.5" 2.5;
  check "-1" (-1.);
  check "0" (-0.);
  check "0.333333" (1. /. 3.);
  check "1e-07" 1e-7;
  check "1e+06" 1e6

(* Each is the shortest decimal form; 0.1 + 0.2 is the double after 0.3, which
   needs all 17 digits. *)
let test_exact () =
  let check expected x =
    Alcotest.(check string) expected expected (Number.to_exact_string x)
  in
  check "0.1" 0.1;
  check "640" 640.;
  check "-3" (-3.);
  check "0.30000000000000004" (0.1 +. 0.2)

let reads_back =
  Property.holds "to_exact_string is read back" ~count:2000
    ~print:QCheck2.Print.float Generate.extreme (fun x ->
      let back = float_of_string (Number.to_exact_string x) in
      Int64.equal (Int64.bits_of_float back) (Int64.bits_of_float x))

let suite =
  ( "Number",
    [
      Alcotest.test_case "rules" `Quick test_rules;
      Alcotest.test_case "require" `Quick test_require;
      Alcotest.test_case "pp" `Quick test_pp;
      Alcotest.test_case "to_exact_string" `Quick test_exact;
      reads_back;
    ] )
