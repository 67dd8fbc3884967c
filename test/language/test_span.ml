open Raylab_language

let check what expected actual = Alcotest.(check int) what expected actual

let test_ends () =
  let span = Span.make ~start:3 ~stop:8 in
  check "start" 3 (Span.start span);
  check "stop" 8 (Span.stop span);
  let empty = Span.make ~start:7 ~stop:7 in
  check "empty start" 7 (Span.start empty);
  check "empty stop" 7 (Span.stop empty)

(* The offsets that the interface promises: up to 2^38, and 16 MB of length. *)
let test_large () =
  let start = (1 lsl 38) - 1 in
  let span = Span.make ~start ~stop:(start + 1000) in
  check "start" start (Span.start span);
  check "stop" (start + 1000) (Span.stop span);
  let long = Span.make ~start:5 ~stop:(1 lsl 30) in
  check "the start of a long one" 5 (Span.start long);
  Alcotest.(check bool)
    "at least some of it" true
    (Span.stop long > 5 + 10_000_000)

let suite =
  ( "Span",
    [
      Alcotest.test_case "ends" `Quick test_ends;
      Alcotest.test_case "large" `Quick test_large;
    ] )
