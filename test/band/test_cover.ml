open Raylab_band
open Test_support

let band part first last = { Cover.part; first; last }
let triple { Cover.part; first; last } = (part, first, last)

let check what ~height bands expected missing =
  let pieces, gaps = Cover.pieces ~height bands in
  Alcotest.(check (list (triple string int int)))
    what expected (List.map triple pieces);
  Alcotest.(check (list (pair int int))) what missing gaps

let test_pieces () =
  check "one" ~height:10 [ band "a" 0 9 ] [ ("a", 0, 9) ] [];
  check "any order" ~height:10
    [ band "b" 4 9; band "a" 0 3 ]
    [ ("a", 0, 3); ("b", 4, 9) ]
    [];
  check "overlap" ~height:10
    [ band "a" 0 5; band "b" 3 9 ]
    [ ("a", 0, 5); ("b", 6, 9) ]
    [];
  check "one in another" ~height:10
    [ band "b" 3 4; band "a" 0 9 ]
    [ ("a", 0, 9) ]
    [];
  check "twice" ~height:2 [ band "a" 0 1; band "b" 0 1 ] [ ("a", 0, 1) ] []

let test_missing () =
  check "all" ~height:10 [] [] [ (0, 9) ];
  check "the first" ~height:10 [ band "a" 1 9 ] [ ("a", 1, 9) ] [ (0, 0) ];
  check "the last" ~height:10 [ band "a" 0 8 ] [ ("a", 0, 8) ] [ (9, 9) ];
  check "between" ~height:10
    [ band "c" 8 9; band "a" 0 2; band "b" 4 5 ]
    [ ("a", 0, 2); ("b", 4, 5); ("c", 8, 9) ]
    [ (3, 3); (6, 7) ]

let test_within () =
  let pieces = [ band "a" 0 3; band "b" 4 6; band "c" 7 9 ] in
  let check what first last expected =
    Alcotest.(check (list (triple string int int)))
      what expected
      (List.map triple (Cover.within ~first ~last pieces))
  in
  check "across" 2 7 [ ("a", 2, 3); ("b", 4, 6); ("c", 7, 7) ];
  check "inside" 5 5 [ ("b", 5, 5) ];
  check "whole" 4 6 [ ("b", 4, 6) ]

(* Every row is in one piece of a band that has it, or in one gap if none
   has. *)
let is_cover (height, bands) =
  let bands = List.map (fun (a, b) -> band () (min a b) (max a b)) bands in
  let pieces, missing = Cover.pieces ~height bands in
  let has row { Cover.first; last; _ } = first <= row && row <= last in
  let count row list = List.length (List.filter (has row) list) in
  let gaps = List.map (fun (first, last) -> band () first last) missing in
  List.for_all
    (fun row ->
      let is_there = List.exists (has row) bands in
      count row pieces = Bool.to_int is_there
      && count row gaps = Bool.to_int (not is_there))
    (List.init height Fun.id)

let any_bands =
  let open QCheck2.Gen in
  let* height = int_range 1 20 in
  let row = int_bound (height - 1) in
  pair (return height) (list_size (int_bound 8) (pair row row))

let print = QCheck2.Print.(pair int (list (pair int int)))

let suite =
  ( "Cover",
    [
      Alcotest.test_case "pieces" `Quick test_pieces;
      Alcotest.test_case "missing rows" `Quick test_missing;
      Alcotest.test_case "within rows" `Quick test_within;
      Property.holds "each row once" ~print any_bands is_cover;
    ] )
