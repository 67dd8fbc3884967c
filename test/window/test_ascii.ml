open Raylab_window

let test_ascii () =
  Alcotest.(check string)
    "one for one" "a?b?\nc"
    (Ascii.of_utf_8 "a\xc3\xa9b\t\nc")

let suite = ("Ascii", [ Alcotest.test_case "of UTF-8" `Quick test_ascii ])
