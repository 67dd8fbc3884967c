(* A scene always ends: what is one too many is an error at its place, and one
   less is none. The places and messages were written before looking. *)

open Raylab_expression
open Raylab_source
open Raylab_language

let header = "imWidth 4 imHeight 3 canvWidth 8 canvHeight 6 depth 5\n"

let read ~steps ~made text =
  let sources = Sources.make ~name:"test.scene" (header ^ text) in
  let budget = Budget.limited ~steps ~made in
  Result.bind (Loader.read Access.none sources).syntax
    (Evaluate.scene ~budget sources)

let told { Scene_error.place; message; _ } =
  match place with
  | None -> message
  | Some { line; first; last } ->
      Printf.sprintf "%d:%d-%d %s" (line - 1) first last message

let check what expected ?(steps = Budget.scene_steps)
    ?(made = Budget.most_made) text =
  let found =
    match read ~steps ~made text with
    | Ok _ -> []
    | Error errors -> List.map told errors
  in
  Alcotest.(check (list string)) what expected found

let times n text = String.concat "" (List.init n (fun _ -> text))

(* {1 Steps} *)

let test_steps () =
  let many what ~steps place text =
    check what
      [
        Printf.sprintf "%s the evaluation takes more than %s steps" place
          (Budget.grouped steps);
      ]
      ~steps text
  in
  check "as many rounds" [] ~steps:10 "for i = 1 to 10 end";
  many "one more" ~steps:9 "1:5-5" "for i = 1 to 10 end";
  many "rounds in rounds" ~steps:50 "2:5-5"
    "for i = 1 to 10\nfor j = 1 to 10 end end";
  many "rounds over a list" ~steps:7 "1:5-5" "for i in [1, 2, 3, 4] end";
  many "operators" ~steps:2 "1:10-14" "let a = (1 + 2 + 3 + 4)";
  many "calls" ~steps:2 "2:17-20" "let f(n) = (n)\nlet a = (f(1) + f(2))";
  many "groups of groups" ~steps:1000 "12:1-3"
    (String.concat ""
       ("let g0 = group end\n"
       :: List.init 10 (fun k ->
              Printf.sprintf "let g%d = group g%d g%d end\n" (k + 1) k k))
    ^ "g10")

(* {1 Objects and elements} *)

let made what n place text =
  check what [] ~made:n text;
  check what
    [
      Printf.sprintf
        "%s more than %d objects and elements of lists are computed" place
        (n - 1);
    ]
    ~made:(n - 1) text

let test_objects () =
  check "literal ones do not count" [] ~made:0
    (times 3 "sphere 0 0 6 1 reflective ");
  made "of a loop" 5 "1:5-5" "for i = 1 to 5 sphere 0 0 6 1 reflective end";
  made "whose numbers are computed" 5 "1:16-35"
    "for i = 1 to 5 sphere 0 0 (i + 1) 1 reflective end";
  made "placed by name" 3 "2:11-14"
    "let ball = sphere 0 0 6 1 reflective\nball ball ball";
  made "of a group that is placed" 6 "3:5-7"
    "let two = group sphere 0 0 6 1 reflective sphere 0 0 7 1 reflective end\n\
     let x = 1\n\
     two two"

let test_elements () =
  made "of a list" 4 "1:10-21" "let l = ([1, 2, 3, 4])";
  made "of a series" 4 "1:10-28" "let l = ([for i = 1 to 4: i])"

(* {1 Nesting} *)

let nested_calls n =
  Printf.sprintf "let f(n) = (if n > 1 then f(n - 1) else 0)\nlet a = (f(%d))"
    n

let test_calls () =
  check "1,000" [] (nested_calls 1000);
  check "1,001"
    [ "1:27-34 more than 1,000 calls are nested" ]
    (nested_calls 1001)

(* A call that makes a group takes some twenty frames of the stack, which has a
   megabyte in JavaScript: where 1,000 do not fit, that is what the error
   says. *)
let fits_1000 = not Test_support.Javascript.here

let test_calls_of_groups () =
  let groups n =
    Printf.sprintf
      "let f(n) = group for i = 1 to 1 if (n > 1) f(n - 1) end end end\nf(%d)"
      n
  in
  check "150" [] (groups 150);
  if fits_1000 then (
    check "1,000" [] (groups 1000);
    check "1,001" [ "1:44-51 more than 1,000 calls are nested" ] (groups 1001))

let nested opening middle closing n =
  times n opening ^ middle ^ times n closing

let test_brackets () =
  let round = nested "(" "1" ")" and square = nested "[" "1" "]" in
  check "1,000" [] ("let a = " ^ round 1000);
  check "1,001"
    [ "1:1009-1009 brackets are nested deeper than 1,000" ]
    ("let a = " ^ round 1001);
  check "lists" [] ("let a = " ^ square 1000);
  check "too deep lists"
    [ "1:1009-1009 brackets are nested deeper than 1,000" ]
    ("let a = " ^ square 1001);
  check "that do not end"
    [ "1:1009-1009 brackets are nested deeper than 1,000" ]
    ("let a = " ^ times 100_000 "(")

let test_blocks () =
  let too_deep place = [ place ^ " blocks are nested deeper than 1,000" ] in
  let blocks opening ~place =
    let text = nested opening "" "end\n" in
    check opening [] (text (if fits_1000 then 1000 else 500));
    check opening (too_deep place) (text 1001)
  in
  blocks "group\n" ~place:"1001:1-1";
  blocks "union\n" ~place:"1001:1-1";
  blocks "if (true)\n" ~place:"1001:1-1";
  blocks "for i = 1 to 1\n" ~place:"1001:1-1"

let test_solids () =
  let solids n =
    let next k = Printf.sprintf "let s%d = union s%d end\n" k (k - 1) in
    "let s0 = sphere 0 0 6 1 reflective\n"
    ^ String.concat "" (List.init n (fun k -> next (k + 1)))
  in
  check "1,000, by their names" [] (solids 1000);
  check "1,001"
    [ "1002:13-27 solids are nested deeper than 1,000" ]
    (solids 1001)

let test_mixes () =
  let mixes n = "sphere 0 0 6 1 " ^ times n "mixed 1 " ^ "reflective" in
  check "1,000" [] (mixes 1000);
  check "1,001"
    [ "1:8016-8020 mixes are nested deeper than 1,000" ]
    (mixes 1001)

let test_operators () =
  let sum n = "let a = (1" ^ times n " + 1" ^ ")" in
  check "1,000" [] (sum 1000);
  check "1,001"
    [ "1:4012-4012 there are more than 1,000 operators in one expression" ]
    (sum 1001)

let suite =
  ( "Limits",
    [
      Alcotest.test_case "steps" `Quick test_steps;
      Alcotest.test_case "objects" `Quick test_objects;
      Alcotest.test_case "elements" `Quick test_elements;
      Alcotest.test_case "calls" `Quick test_calls;
      Alcotest.test_case "calls of groups" `Quick test_calls_of_groups;
      Alcotest.test_case "brackets" `Quick test_brackets;
      Alcotest.test_case "blocks" `Quick test_blocks;
      Alcotest.test_case "solids" `Quick test_solids;
      Alcotest.test_case "mixes" `Quick test_mixes;
      Alcotest.test_case "operators" `Quick test_operators;
    ] )
