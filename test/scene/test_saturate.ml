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

let suite =
  ( "Saturate",
    [
      Alcotest.test_case "limit" `Quick test_limit;
      Alcotest.test_case "color" `Quick test_color;
    ] )
