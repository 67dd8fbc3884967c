open Raylab_window

let lines = Alcotest.(list string)

let test_ascii () =
  Alcotest.(check string)
    "one for one" "a?b?\nc"
    (Ascii.of_utf_8 "a\xc3\xa9b\t\nc")

let test_wrap () =
  let check name expected ~columns ~rows text =
    Alcotest.check lines name expected (Ascii.wrap ~columns ~rows text)
  in
  check "as it is" [ "ab"; ""; "cd" ] ~columns:9 ~rows:9 "ab\n\ncd";
  check "long lines" [ "abc"; "def"; "g" ] ~columns:3 ~rows:9 "abcdefg";
  check "at blanks" [ "ab"; "cde"; "f g" ] ~columns:3 ~rows:9 "ab cde f g";
  check "a full line" [ "abc" ] ~columns:3 ~rows:9 "abc";
  check "too many" [ "a"; "..." ] ~columns:3 ~rows:2 "a\nb\nc";
  check "no room" [] ~columns:0 ~rows:5 "a"

let suite =
  ( "Ascii",
    [
      Alcotest.test_case "of UTF-8" `Quick test_ascii;
      Alcotest.test_case "wrap" `Quick test_wrap;
    ] )
