open Raylab_language
open Test_support

let check_first text expected =
  let found { Lookalike.start; stop; name; _ } = (start, stop, name) in
  Alcotest.(check (option (triple int int string)))
    (String.escaped text) expected
    (Option.map found (Lookalike.first text))

let test_first () =
  check_first "sphere -1.5" None;
  check_first "\u{17c}\u{f3}\u{142}ty" None;
  check_first "0\u{a0}1\u{a0}" (Some (1, 3, "U+00A0, a no-break space"));
  check_first "ab\u{2212}" (Some (2, 5, "U+2212, a minus sign"));
  check_first "a\x00" (Some (1, 2, "U+0000, a NUL"));
  check_first "a\u{e0001}" (Some (1, 5, "U+E0001, an invisible character"));
  check_first "a\xe9\xe9" (Some (1, 2, "byte E9, which is no UTF-8"))

let test_plain () =
  let check text expected =
    Alcotest.(check string)
      (String.escaped text) expected (Lookalike.plain text)
  in
  check "sphere" "sphere";
  check "\u{17c}\u{f3}\u{142}ty" "\u{17c}\u{f3}\u{142}ty";
  check "\u{2212}1\u{a0}\u{2013}2" "-1 -2";
  check "\u{feff}re\u{ad}flective\u{200b}" "reflective";
  check "\u{201c}\u{2018}" "\"'";
  check "\u{441}\u{443}\u{430}n" "cyan";
  check "\u{ff0d}\u{ff11}\u{ff0e}\u{ff15}" "-1.5";
  check "1\xa0\x962" "1 -2";
  check "\xe9" "\xe9"

let characters =
  let open QCheck2.Gen in
  let character = oneof [ 0 -- 0x7ff; 0x2000 -- 0x22ff; 0xfe00 -- 0xffff ] in
  let text codes =
    let out = Buffer.create 100 in
    List.iter (fun c -> Buffer.add_utf_8_uchar out (Uchar.of_int c)) codes;
    Buffer.contents out
  in
  map text (list_size (0 -- 20) character)

let plain_is_plain =
  Property.holds "plain leaves nothing to do" ~count:2000 characters
    (fun text -> Lookalike.(first (plain text)) = None)

let suite =
  ( "Lookalike",
    [
      Alcotest.test_case "first" `Quick test_first;
      Alcotest.test_case "plain" `Quick test_plain;
      plain_is_plain;
    ] )
