open Raylab_drawing
open Raylab_viewer

let lines = Alcotest.(list string)

let test_wrap () =
  let check name expected ~columns ~rows text =
    Alcotest.check lines name expected (Message.wrap ~columns ~rows text)
  in
  check "as it is" [ "ab"; ""; "cd" ] ~columns:9 ~rows:9 "ab\n\ncd";
  check "long lines" [ "abc"; "def"; "g" ] ~columns:3 ~rows:9 "abcdefg";
  check "at blanks" [ "ab"; "cde"; "f g" ] ~columns:3 ~rows:9 "ab cde f g";
  check "a full line" [ "abc" ] ~columns:3 ~rows:9 "abc";
  check "between characters"
    [ "\u{e9}\u{e9}"; "\u{e9}" ]
    ~columns:2 ~rows:9 "\u{e9}\u{e9}\u{e9}";
  check "too many" [ "a"; "..." ] ~columns:3 ~rows:2 "a\nb\nc";
  check "no room" [] ~columns:0 ~rows:5 "a"

let test_draw () =
  let text_size words = (6. *. float_of_int (String.length words), 13.) in
  let written : Drawing.mark -> _ = function
    | Text { words; place; _ } -> (words, place)
    | _ -> Alcotest.fail "words"
  in
  let window = { Rectangle.left = 0.; top = 0.; right = 39.; bottom = 50. } in
  Alcotest.(check (list (pair string (pair (float 0.) (float 0.)))))
    "in the margins"
    [ ("abc", (10., 10.)); ("...", (10., 25.)) ]
    (List.map written (Message.draw ~text_size window "abcdefgh"))

let suite =
  ( "Message",
    [
      Alcotest.test_case "wrap" `Quick test_wrap;
      Alcotest.test_case "draw" `Quick test_draw;
    ] )
