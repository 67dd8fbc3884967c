open Raylab_source

let files texts =
  List.fold_left
    (fun files (name, text) -> Files.add ~name (Lines.index text) files)
    Files.none texts

let place = Alcotest.(option (pair (option string) int))

let check what expected files offset =
  let told { Place.file; line } = (file, line) in
  Alcotest.check place what expected
    (Option.map told (Files.place files offset))

(* Offsets: 0 to 4 are of the first, 5 of the second, 6 to 8 of the third. *)
let three = files [ ("a", "a\nb\n"); ("b", ""); ("c", "\nc") ]

let test_place () =
  check "none" None Files.none 0;
  check "before" None three (-1);
  check "the start" (Some (None, 1)) three 0;
  check "the end of the main one" (Some (None, 3)) three 4;
  check "an empty one" (Some (Some "b", 1)) three 5;
  check "the start of the last" (Some (Some "c", 1)) three 6;
  check "its end" (Some (Some "c", 2)) three 8;
  check "beyond" None three 9;
  Alcotest.(check int) "last" 8 (Files.last three);
  Alcotest.(check int) "last of none" (-1) (Files.last Files.none)

let test_many () =
  let many = files (List.init 1000 (fun k -> (string_of_int k, "a\nb"))) in
  List.iter
    (fun k ->
      check "line 1" (Some (Some (string_of_int k), 1)) many (4 * k);
      check "line 2" (Some (Some (string_of_int k), 2)) many ((4 * k) + 3))
    [ 1; 2; 499; 500; 998; 999 ]

let test_as_data () =
  let copy = Marshal.from_string (Marshal.to_string three []) 0 in
  Alcotest.(check bool) "is data" true (copy = three)

let test_words () =
  let check expected place =
    Alcotest.(check string) expected expected (Place.to_string place)
  in
  check "line 30" { file = None; line = 30 };
  check "line 3 of wood.scene" { file = Some "wood.scene"; line = 3 }

let suite =
  ( "Files",
    [
      Alcotest.test_case "place" `Quick test_place;
      Alcotest.test_case "many files" `Quick test_many;
      Alcotest.test_case "as data" `Quick test_as_data;
      Alcotest.test_case "words" `Quick test_words;
    ] )
