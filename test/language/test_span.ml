open Raylab_source
open Raylab_language

let check what expected actual = Alcotest.(check int) what expected actual

let test_ends () =
  let span = Span.make ~start:3 ~stop:8 in
  check "start" 3 (Span.start span);
  check "stop" 8 (Span.stop span);
  let empty = Span.make ~start:7 ~stop:7 in
  check "empty start" 7 (Span.start empty);
  check "empty stop" 7 (Span.stop empty)

(* The offsets that the interface promises: all that a scene can have. *)
let test_large () =
  List.iter
    (fun (start, stop) ->
      let span = Span.make ~start ~stop in
      check "start" start (Span.start span);
      check "stop" stop (Span.stop span))
    [
      (Scene_file.max_size - 1, Scene_file.max_size);
      (Scene_file.max_size, Scene_file.max_size);
      (0, Scene_file.max_size);
    ]

let suite =
  ( "Span",
    [
      Alcotest.test_case "ends" `Quick test_ends;
      Alcotest.test_case "large" `Quick test_large;
    ] )
