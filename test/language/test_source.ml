open Raylab_source
open Raylab_language
open Test_support

let source = Source.make ~name:"test.scene"
let span start stop = Span.make ~start ~stop

let check_place what text (start, stop) (line, first, last) =
  let place = Source.place (source text) (span start stop) in
  Alcotest.(check (triple int int int))
    what (line, first, last)
    (place.line, place.first, place.last)

(* Offsets: a0 b1 \n2 c3 d4 \r5 \n6 e7 f8. *)
let test_place () =
  let check what = check_place what "ab\ncd\r\nef" in
  check "first line" (0, 2) (1, 1, 2);
  check "one byte" (4, 5) (2, 2, 2);
  check "last line" (7, 9) (3, 1, 2);
  check "over a line's end" (1, 5) (1, 2, 2);
  check "CR is no part of the line" (3, 8) (2, 1, 2);
  check "empty" (3, 3) (2, 1, 1);
  check "the end" (9, 9) (3, 3, 3);
  check_place "after CR" "a\rbc" (2, 4) (2, 1, 2);
  check_place "after the last line end" "ab\n" (3, 3) (2, 1, 1);
  check_place "nothing" "" (0, 0) (1, 1, 1)

(* Characters of more than one byte and a tab before the place: the marker
   counts characters. Offsets: tab0 x1 ' '2 e'3-4 ' '5 y6. *)
let test_excerpt () =
  let check what text (start, stop) expected =
    Alcotest.(check (triple string int int))
      what expected
      (Source.excerpt (source text) (span start stop))
  in
  check "whole line" "ab\ncd ef\ngh" (6, 8) ("cd ef", 3, 2);
  check "characters" "\tx \xc3\xa9 y" (6, 7) (" x \xc3\xa9 y", 5, 1);
  check "a marked character" "x \xc3\xa9 y" (2, 4) ("x \xc3\xa9 y", 2, 1);
  check "empty span" "ab" (2, 2) ("ab", 2, 1);
  check "CR LF" "ab\r\n" (0, 1) ("ab", 0, 1);
  check "CR" "ab\rcd\ref" (3, 4) ("cd", 0, 1)

let test_long_line () =
  let text = String.make 500 'a' ^ "HERE" ^ String.make 500 'b' in
  let line, before, length = Source.excerpt (source text) (span 500 504) in
  Alcotest.(check string) "marked" "HERE" (String.sub line before length);
  Alcotest.(check bool) "shortened" true (String.length line < 120)

let test_printable () =
  let check what expected text =
    Alcotest.(check string) what expected (Source.printable text)
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

let test_name () =
  Alcotest.(check string)
    "printable" "a\u{FFFD}b"
    (Source.name (Source.make ~name:"a\nb" ""));
  Alcotest.(check string)
    "bytes as they are" "\x00\xff"
    (Source.text (source "\x00\xff"))

(* Offsets: 1'0 2'2 #4 ... the line end'7 3'9, and the end at 10. *)
let test_word () =
  let check text offset (start, stop) =
    let word = Source.next_word (source text) offset in
    Alcotest.(check (pair int int))
      (Printf.sprintf "from %d" offset)
      (start, stop)
      (Span.start word, Span.stop word)
  in
  let check_all text =
    check text 0 (0, 1);
    check text 1 (2, 3);
    check text 3 (9, 10);
    check text 10 (10, 10)
  in
  check_all "1 2 # x\n 3";
  check_all "1 2 # x\r 3"

let test_quote () =
  Alcotest.(check string)
    "short" "cd"
    (Source.quote (source "ab cd") (span 3 5));
  let long = Source.quote (source (String.make 1000 'x')) (span 0 1000) in
  Alcotest.(check bool) "long" true (String.length long < 100);
  Alcotest.(check string)
    "printable" "\u{FFFD}"
    (Source.quote (source "\x00") (span 0 1))

let marks_the_span =
  Property.holds "the excerpt marks the span" ~count:2000
    QCheck2.Gen.(
      triple
        (string_size ~gen:(char_range ' ' '~') (0 -- 200))
        (0 -- 200) (1 -- 10))
    (fun (text, start, length) ->
      let start = min start (String.length text) in
      let length = min length (String.length text - start) in
      let line, before, marked =
        Source.excerpt (source text) (span start (start + length))
      in
      if length = 0 then marked = 1
      else String.sub line before marked = String.sub text start length)

let printable_is_printable =
  Property.holds "printable leaves nothing to do" ~count:2000
    QCheck2.Gen.string (fun text ->
      let once = Source.printable text in
      String.is_valid_utf_8 once
      && String.equal once (Source.printable once)
      && String.for_all (fun c -> c >= ' ') once)

let suite =
  ( "Source",
    [
      Alcotest.test_case "place" `Quick test_place;
      Alcotest.test_case "excerpt" `Quick test_excerpt;
      Alcotest.test_case "excerpt of a long line" `Quick test_long_line;
      Alcotest.test_case "printable" `Quick test_printable;
      Alcotest.test_case "name and text" `Quick test_name;
      Alcotest.test_case "word" `Quick test_word;
      Alcotest.test_case "quote" `Quick test_quote;
      marks_the_span;
      printable_is_printable;
    ] )
