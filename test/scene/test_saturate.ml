open Raylab_scene
open Test_support

let check = Alcotest.check Same.number

let test_limit () =
  check "everyday" 0.7 (Saturate.limit 0.7);
  check "0" 0. (Saturate.limit 0.);
  check "largest" max_float (Saturate.limit max_float);
  check "infinity" max_float (Saturate.limit infinity);
  check "NaN" 0. (Saturate.limit nan)

let test_color () =
  Alcotest.check Same.color "each channel"
    (Build.rgb 0.5 max_float 0.)
    (Saturate.color (Build.rgb 0.5 infinity nan))

let test_register () =
  let register = Raw_color.create () in
  Alcotest.check Same.color "at first" Color.black
    (Raw_color.to_color register);
  Raw_color.set register 0.5 infinity nan;
  Alcotest.check Same.color "each channel"
    (Build.rgb 0.5 max_float 0.)
    (Raw_color.to_color register)

let suite =
  ( "Saturate",
    [
      Alcotest.test_case "limit" `Quick test_limit;
      Alcotest.test_case "color" `Quick test_color;
      Alcotest.test_case "register" `Quick test_register;
    ] )
