open Raylab_source
open Test_support

let test_printable () =
  let check what expected text =
    Alcotest.(check string) what expected (Printable.text text)
  in
  let no = "\u{FFFD}" in
  check "text" "sphere 0 \xc3\xa9" "sphere 0 \xc3\xa9";
  check "tab" "a b" "a\tb";
  check "escape" (no ^ "[31m") "\x1b[31m";
  check "NUL" (no ^ "a") "\x00a";
  check "DEL" no "\x7f";
  check "C1" no "\xc2\x9b";
  check "invalid" ("a" ^ no ^ "b") "a\xffb";
  check "reversing text" no "\u{202E}"

let printable_is_printable =
  Property.holds "text leaves nothing to do" ~count:2000 QCheck2.Gen.string
    (fun text ->
      let once = Printable.text text in
      String.is_valid_utf_8 once
      && String.equal once (Printable.text once)
      && String.for_all (fun c -> c >= ' ') once)

let suite =
  ( "Printable",
    [ Alcotest.test_case "text" `Quick test_printable; printable_is_printable ]
  )
