open Raylab_scene
open Raylab_tracer
open Raylab_toplevel

(* Events that are told apart by a number. *)
let event k = Event.Done (Color.make k 0. 0.)

let number : Event.t * Walk.t -> float = function
  | Done { r; _ }, _ -> r
  | _ -> Alcotest.fail "not one of these events"

let check what expected place =
  Alcotest.(check (option (float 0.))) what expected (Option.map number place)

let go way place = Option.bind place (fun (_, place) -> way place)
let start () = Walk.start (List.to_seq [ event 1.; event 2.; event 3. ])

let test_next () =
  let one = Walk.next (start ()) in
  let two = go Walk.next one in
  let three = go Walk.next two in
  check "first" (Some 1.) one;
  check "second" (Some 2.) two;
  check "third" (Some 3.) three;
  check "the end" None (go Walk.next three);
  check "of nothing" None (Walk.next (Walk.start Seq.empty))

let test_back () =
  let one = Walk.next (start ()) in
  let three = go Walk.next (go Walk.next one) in
  let back = go Walk.back three in
  check "before the first" None (Walk.back (start ()));
  check "from the first" None (go Walk.back one);
  check "from the third" (Some 2.) back;
  check "twice" (Some 1.) (go Walk.back back);
  check "and on" (Some 3.) (go Walk.next back)

let test_persistent () =
  let one = Walk.next (start ()) in
  let two = go Walk.next one in
  ignore (go Walk.next two);
  ignore (go Walk.back two);
  check "an old place goes on" (Some 3.) (go Walk.next two);
  check "and back" (Some 1.) (go Walk.back two);
  check "and again" (Some 2.) (go Walk.next one)

(* What comes is not looked at before it is asked for. *)
let test_lazy () =
  let events = Seq.cons (event 1.) (fun () -> Alcotest.fail "too early") in
  check "first" (Some 1.) (Walk.next (Walk.start events))

let suite =
  ( "Walk",
    [
      Alcotest.test_case "next" `Quick test_next;
      Alcotest.test_case "back" `Quick test_back;
      Alcotest.test_case "persistent" `Quick test_persistent;
      Alcotest.test_case "lazy" `Quick test_lazy;
    ] )
