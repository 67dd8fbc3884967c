open Raylab_geometry
open Test_support

(* What is left of a ray, cut off at [reach], when these numbers, parts and
   distances have been offered one after another. *)
let after ?(reach = infinity) offers =
  let meeting = Meeting.create () and ray = Raw_ray.create () in
  ray.reach <- reach;
  List.iter
    (fun (number, part, t) -> Meeting.offer meeting ray ~number ~part t)
    offers;
  if Meeting.is_none meeting then (None, ray.reach)
  else (Some (meeting.number, meeting.part), ray.reach)

let check ?reach what expected offers =
  Alcotest.(check (pair (option (pair int int)) Same.number))
    what expected (after ?reach offers)

let test_nearest () =
  check "none" (None, infinity) [];
  check "one" (Some (3, 2), 5.) [ (3, 2, 5.) ];
  check "the nearer" (Some (1, 4), 2.) [ (0, 3, 5.); (1, 4, 2.); (2, 5, 3.) ];
  check "whichever order" (Some (1, 4), 2.) [ (1, 4, 2.); (0, 3, 5.) ]

let test_ties () =
  check "the lower number, first" (Some (1, 7), 5.) [ (1, 7, 5.); (2, 8, 5.) ];
  check "the lower number, last" (Some (1, 7), 5.) [ (2, 8, 5.); (1, 7, 5.) ];
  check "the part that was first" (Some (1, 7), 5.) [ (1, 7, 5.); (1, 8, 5.) ];
  check "nearer beats lower"
    (Some (9, 0), Float.pred 5.)
    [ (0, 0, 5.); (9, 0, Float.pred 5.) ]

let test_reach () =
  let none = (None, 5.) in
  check ~reach:5. "before it"
    (Some (0, 0), Float.pred 5.)
    [ (0, 0, Float.pred 5.) ];
  check ~reach:5. "at it" none [ (0, 0, 5.) ];
  check ~reach:5. "beyond it" none [ (0, 0, 6.) ];
  check ~reach:0. "no reach" (None, 0.) [ (0, 0, 5e-324) ];
  check ~reach:nan "a reach that is no number" (None, nan) [ (0, 0, 5.) ]

let test_no_hits () =
  check "NaN, infinity, 0 and behind" (None, infinity)
    (List.map
       (fun t -> (0, 0, t))
       [ nan; infinity; neg_infinity; 0.; -0.; -1. ]);
  check "the smallest is one" (Some (0, 0), 5e-324) [ (0, 0, 5e-324) ];
  check "the largest is one" (Some (0, 0), max_float) [ (0, 0, max_float) ];
  check "after a hit"
    (Some (1, 0), 5.)
    [ (1, 0, 5.); (0, 0, nan); (0, 0, infinity); (0, 0, 0.); (0, 0, -5.) ]

let test_clear () =
  let meeting = Meeting.create () and ray = Raw_ray.create () in
  Alcotest.(check bool) "created" true (Meeting.is_none meeting);
  Meeting.offer meeting ray ~number:0 ~part:0 1.;
  Alcotest.(check bool) "met" false (Meeting.is_none meeting);
  Meeting.clear meeting;
  Alcotest.(check bool) "cleared" true (Meeting.is_none meeting);
  Alcotest.(check int) "none" Meeting.none meeting.number

(* The least positive distance before the reach, and of those that have it the
   lowest number, in whatever order. *)
let any_order =
  Property.holds "the least, then the lowest" ~count:2000
    QCheck2.Gen.(
      triple
        (list_size (0 -- 8)
           (oneofl [ nan; infinity; -1.; 0.; 0.5; 1.; 2.; 3. ]))
        (oneofl [ infinity; 3.; 1. ])
        (int_bound 1_000_000))
    (fun (distances, reach, seed) ->
      let offers = List.mapi (fun number t -> (number, 0, t)) distances in
      let is_hit (_, _, t) = 0. < t && t < reach in
      let expected =
        let by_distance (a, _, t) (b, _, t') = compare (t, a) (t', b) in
        match List.sort by_distance (List.filter is_hit offers) with
        | [] -> (None, reach)
        | (number, part, t) :: _ -> (Some (number, part), t)
      in
      let shuffled =
        QCheck2.Gen.(
          generate1 ~rand:(Random.State.make [| seed |]) (shuffle_l offers))
      in
      after ~reach shuffled = expected)

let suite =
  ( "Meeting",
    [
      Alcotest.test_case "nearest" `Quick test_nearest;
      Alcotest.test_case "ties" `Quick test_ties;
      Alcotest.test_case "reach" `Quick test_reach;
      Alcotest.test_case "no hits" `Quick test_no_hits;
      Alcotest.test_case "clear" `Quick test_clear;
      any_order;
    ] )
