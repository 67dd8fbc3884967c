open Raylab_viewer

let gesture = function
  | Hand.Nothing -> "nothing"
  | Click (x, y) -> Printf.sprintf "click at %d %d" x y
  | Drag { across; down } -> Printf.sprintf "drag by %d %d" across down

let check what expected found =
  Alcotest.(check string) what expected (gesture found)

let moved place hand = fst (Hand.move place hand)

let test_gestures () =
  let held = Hand.press (10, 20) in
  check "no button" "nothing" (snd (Hand.move (5, 5) Hand.free));
  check "a click" "click at 10 20" (Hand.release (10, 20) held);
  check "an unsteady one" "click at 10 20" (Hand.release (7, 23) held);
  check "on its way" "nothing" (snd (Hand.move (13, 17) held));
  check "a drag" "drag by 4 0" (snd (Hand.move (14, 20) held));
  check "upwards" "drag by 1 -4" (Hand.release (11, 16) held);
  let drags = moved (30, 20) held in
  check "back to where it began" "drag by 0 0" (snd (Hand.move (10, 20) drags));
  check "and there is no click" "drag by 0 0" (Hand.release (10, 20) drags)

let suite = ("Hand", [ Alcotest.test_case "gestures" `Quick test_gestures ])
