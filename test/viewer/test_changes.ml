open Raylab_viewer

(* what each of these sights of a file, at these times, is: a change or not *)
let run sights =
  let _, changes =
    List.fold_left
      (fun (state, changes) (now, stamp) ->
        let state, changed = Changes.step ~now stamp state in
        (state, changed :: changes))
      (Changes.initial (Some "a"), [])
      sights
  in
  List.rev changes

let check name expected sights =
  Alcotest.(check (list bool)) name expected (run sights)

let test_steps () =
  check "the same" [ false; false ] [ (0., Some "a"); (1., Some "a") ];
  check "another, told once, when it has settled"
    [ false; false; true; false ]
    [ (0., Some "b"); (0.04, Some "b"); (0.1, Some "b"); (1., Some "b") ];
  check "in the middle of writing"
    [ false; false; false; true ]
    [ (0., Some "b"); (0.1, Some "c"); (0.2, Some "d"); (0.3, Some "d") ];
  check "back again"
    [ false; true; false; true ]
    [ (0., Some "b"); (1., Some "b"); (2., Some "a"); (3., Some "a") ];
  check "away for a moment"
    [ false; false; false; false ]
    [ (0., None); (0.5, None); (0.6, Some "a"); (2., Some "a") ];
  check "away and replaced" [ false; false; true ]
    [ (0., None); (0.1, Some "b"); (0.2, Some "b") ];
  check "away for long, once, and back"
    [ false; true; false; false; true ]
    [ (0., None); (1.5, None); (3., None); (4., Some "a"); (5., Some "a") ]

let suite = ("Changes", [ Alcotest.test_case "changes" `Quick test_steps ])
