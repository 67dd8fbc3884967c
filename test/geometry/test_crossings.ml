open Raylab_geometry
open Test_support

let check what ~starts_inside expected added =
  let crossings = Crossings.create () in
  Crossings.clear crossings ~starts_inside;
  List.iter (fun (part, t) -> Crossings.add crossings ~part t) added;
  Alcotest.(check (list (triple int Same.number bool)))
    what expected
    (List.map
       (fun { Crossings.t; part; enters } -> (part, t, enters))
       (Crossings.to_list crossings))

let test_turns () =
  check "none" ~starts_inside:false [] [];
  check "in and out, twice" ~starts_inside:false
    [ (4, 1., true); (5, 2., false); (6, 3., true); (7, 3., false) ]
    [ (4, 1.); (5, 2.); (6, 3.); (7, 3.) ];
  check "out first" ~starts_inside:true
    [ (0, -1., false); (1, 1., true); (0, 2., false) ]
    [ (0, -1.); (1, 1.); (0, 2.) ]

(* There is room for eight at first. *)
let test_growth () =
  List.iter
    (fun count ->
      let part k = 3 * k and t k = float_of_int k /. 2. in
      check (string_of_int count) ~starts_inside:true
        (List.init count (fun k -> (part k, t k, k mod 2 = 1)))
        (List.init count (fun k -> (part k, t k))))
    [ 7; 8; 9; 16; 17; 100 ]

let test_clear () =
  let crossings = Crossings.create () in
  Alcotest.(check int) "created" 0 crossings.count;
  Alcotest.(check bool) "outside" false crossings.starts_inside;
  for k = 0 to 20 do
    Crossings.add crossings ~part:k (float_of_int k)
  done;
  Crossings.clear crossings ~starts_inside:true;
  Alcotest.(check int) "cleared" 0 crossings.count;
  Crossings.add crossings ~part:2 0.5;
  Alcotest.(check bool)
    "the new one alone" true
    (Crossings.to_list crossings = [ { t = 0.5; part = 2; enters = false } ])

let suite =
  ( "Crossings",
    [
      Alcotest.test_case "by turns" `Quick test_turns;
      Alcotest.test_case "many" `Quick test_growth;
      Alcotest.test_case "clear" `Quick test_clear;
    ] )
