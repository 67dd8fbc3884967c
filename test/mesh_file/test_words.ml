open Raylab_mesh_file

let all text =
  let words = Words.start text in
  let rec go found =
    if Words.next_anywhere words then
      go ((Words.line words, Words.raw words) :: found)
    else List.rev found
  in
  go []

let test_words () =
  let check what expected text =
    Alcotest.(check (list (pair int string))) what expected (all text)
  in
  check "blanks" [ (1, "a"); (1, "b") ] " a\t b ";
  check "line ends" [ (1, "a"); (2, "b"); (3, "c"); (4, "d") ] "a\nb\r\nc\rd";
  check "comments" [ (1, "a"); (2, "b") ] "a # x y\nb #";
  check "lines that go on"
    [ (1, "a"); (2, "b"); (4, "c") ]
    "a \\\nb\\\n \\\r\nc";
  check "a backslash within a line" [ (1, "a\\b"); (1, "\\") ] "a\\b \\ #";
  check "nothing" [] "\n \n"

let test_numbers () =
  let number text =
    let words = Words.start text in
    ignore (Words.next words : bool);
    match Words.number words with
    | x -> Some x
    | exception Fault.Found _ -> None
  in
  let check expected text =
    Alcotest.(check (option (float 0.))) text expected (number text)
  in
  check (Some 0.8) ".8";
  check (Some (-70.)) "-.7e+2";
  check (Some 1.) "+1.";
  check (Some 1e-5) "1e-5";
  check (Some 0.1) "0.1000000000000000000001";
  List.iter (check None)
    [
      ".";
      "-";
      "e1";
      "1e";
      "1e+";
      "nan";
      "inf";
      "1.#IND";
      "0x10";
      "1_0";
      "1e999";
    ]

let suite =
  ( "Words",
    [
      Alcotest.test_case "words" `Quick test_words;
      Alcotest.test_case "numbers" `Quick test_numbers;
    ] )
