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

(* Paper below the words, at the top unless that is in the way. *)
let test_note () =
  let text_size words = (6. *. float_of_int (String.length words), 13.) in
  let window = { Rectangle.left = 0.; top = 0.; right = 120.; bottom = 90. } in
  let check name ?avoid (top, bottom) (free_top, free_bottom) words =
    match Message.note ~text_size ?avoid window words with
    | rest, Box (_, box) :: _ ->
        Alcotest.(check (pair (float 0.) (float 0.)))
          name (top, bottom) (box.top, box.bottom);
        Alcotest.(check (pair (float 0.) (float 0.)))
          (name ^ ": the rest") (free_top, free_bottom) (rest.top, rest.bottom)
    | _ -> Alcotest.failf "%s: no paper" name
  in
  check "a line" (0., 25.) (25., 90.) "saved";
  check "two lines" (0., 40.) (40., 90.) "one two three four five";
  check "no more than half" (0., 40.) (40., 90.) (String.make 500 'x');
  check "below"
    ~avoid:{ left = 50.; top = 10.; right = 60.; bottom = 20. }
    (65., 90.) (0., 65.) "saved";
  check "beside"
    ~avoid:{ left = 50.; top = 50.; right = 60.; bottom = 60. }
    (0., 25.) (25., 90.) "saved";
  Alcotest.(check bool)
    "no room" true
    (Message.note ~text_size { window with bottom = 20. } "saved"
    = ({ window with bottom = 20. }, []))

let suite =
  ( "Message",
    [
      Alcotest.test_case "wrap" `Quick test_wrap;
      Alcotest.test_case "draw" `Quick test_draw;
      Alcotest.test_case "note" `Quick test_note;
    ] )
