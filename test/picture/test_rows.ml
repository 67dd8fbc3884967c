open Raylab_picture

let check what expected ~width ~first ~last =
  Alcotest.(check (list (pair int int)))
    what expected
    (List.of_seq (Rows.pieces ~width ~first ~last))

(* A megabyte has 1,048,576 bytes: three rows of 100,000 pixels. *)
let test_pieces () =
  check "one row" [ (5, 1) ] ~width:1 ~first:5 ~last:5;
  check "several" [ (2, 3); (5, 3); (8, 1) ] ~width:100_000 ~first:2 ~last:8;
  check "long rows" [ (0, 1); (1, 1) ] ~width:1_000_000 ~first:0 ~last:1

let rgb = Bytes.of_string "aaabbbcccddd"
let rows = Rows.of_bytes ~width:1 ~top:10 rgb

let test_bytes () =
  Alcotest.(check bytes)
    "two rows" (Bytes.of_string "bbbccc") (rows ~first:11 ~count:2)

let seen ~lowest_first ~width ~first ~last =
  let seen = ref [] in
  Rows.iter ~lowest_first ~width ~first ~last ignore (fun ~first ~count:_ ->
      seen := first :: !seen;
      Bytes.empty);
  List.rev !seen

let test_iter () =
  let check what expected ~lowest_first =
    Alcotest.(check (list int))
      what expected
      (seen ~lowest_first ~width:100_000 ~first:2 ~last:8)
  in
  check "from the top" [ 2; 5; 8 ] ~lowest_first:false;
  check "from below" [ 8; 5; 2 ] ~lowest_first:true

let suite =
  ( "Rows",
    [
      Alcotest.test_case "pieces" `Quick test_pieces;
      Alcotest.test_case "of bytes" `Quick test_bytes;
      Alcotest.test_case "in either order" `Quick test_iter;
    ] )
