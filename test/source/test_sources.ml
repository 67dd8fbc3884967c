open Raylab_source
open Test_support

let source = Sources.make ~name:"test.scene"
let span start stop = { Span.start; stop }

let check_place what text (start, stop) (line, first, last) =
  let place = Sources.place (source text) (span start stop) in
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
      (Sources.excerpt (source text) (span start stop))
  in
  check "whole line" "ab\ncd ef\ngh" (6, 8) ("cd ef", 3, 2);
  check "characters" "\tx \xc3\xa9 y" (6, 7) (" x \xc3\xa9 y", 5, 1);
  check "a marked character" "x \xc3\xa9 y" (2, 4) ("x \xc3\xa9 y", 2, 1);
  check "empty span" "ab" (2, 2) ("ab", 2, 1);
  check "CR LF" "ab\r\n" (0, 1) ("ab", 0, 1);
  check "CR" "ab\rcd\ref" (3, 4) ("cd", 0, 1)

let test_long_line () =
  let text = String.make 500 'a' ^ "HERE" ^ String.make 500 'b' in
  let line, before, length = Sources.excerpt (source text) (span 500 504) in
  Alcotest.(check string) "marked" "HERE" (String.sub line before length);
  Alcotest.(check bool) "shortened" true (String.length line < 120)

let test_name () =
  Alcotest.(check string)
    "printable" "a\u{FFFD}b"
    (Sources.name (Sources.make ~name:"a\nb" "") 0);
  let check what expected text =
    let { Sources.text; _ } = Sources.file (source text) 0 in
    Alcotest.(check string) what expected text
  in
  check "bytes as they are" "\x00\xff" "\x00\xff";
  check "no byte-order mark" "a\xef\xbb\xbf" "\xef\xbb\xbfa\xef\xbb\xbf"

(* Two files, the first of which has no line end at its end: a0 b1 \n2 c3, its
   end 4; d5 \n6 e7 f8, its end 9. *)
let two =
  Sources.make ~path:"x/a.scene" ~name:"a.scene" "ab\nc"
  |> Sources.add ~name:"b\x00.scene" "d\nef"

let test_two_files () =
  let check what (start, stop) (name, (line, first, last), text, excerpt) =
    let span = span start stop in
    let place = Sources.place two span in
    Alcotest.(check string) what name (Sources.name two start);
    Alcotest.(check (triple int int int))
      what (line, first, last)
      (place.line, place.first, place.last);
    Alcotest.(check string) what text (Sources.slice two span);
    Alcotest.(check (triple string int int))
      what excerpt (Sources.excerpt two span)
  in
  let a = "a.scene" and b = "b\u{FFFD}.scene" in
  check "in the first" (3, 4) (a, (2, 1, 1), "c", ("c", 0, 1));
  check "its end" (4, 4) (a, (2, 2, 2), "", ("c", 1, 1));
  check "the start of the second" (5, 6) (b, (1, 1, 1), "d", ("d", 0, 1));
  check "further on" (8, 9) (b, (2, 2, 2), "f", ("ef", 1, 1));
  check "the end" (9, 9) (b, (2, 3, 3), "", ("ef", 2, 1));
  Alcotest.(check (list (triple string int string)))
    "files"
    [ ("x/a.scene", 0, "ab\nc"); ("b\x00.scene", 5, "d\nef") ]
    (List.map
       (fun { Sources.path; base; text } -> (path, base, text))
       (Sources.files two));
  Alcotest.(check int) "size" 8 (Sources.size two);
  Expect.invalid "beyond" (fun () -> Sources.name two 10)

let test_digest () =
  let of_texts texts =
    List.fold_left
      (fun sources text -> Sources.add ~name:"" text sources)
      Sources.none texts
    |> Sources.digest |> Digest.to_hex
  in
  Alcotest.(check string)
    "of one file"
    (Digest.to_hex (Digest.string "abc"))
    (of_texts [ "abc" ]);
  let digests =
    List.map of_texts
      [ [ "abc" ]; [ "ab"; "c" ]; [ "a"; "bc" ]; [ "c"; "ab" ]; [ "abc"; "" ] ]
  in
  Alcotest.(check int)
    "all differ" 5
    (List.length (List.sort_uniq String.compare digests))

let test_quote () =
  Alcotest.(check string)
    "short" "cd"
    (Sources.quote (source "ab cd") (span 3 5));
  let long = Sources.quote (source (String.make 1000 'x')) (span 0 1000) in
  Alcotest.(check bool) "long" true (String.length long < 100);
  Alcotest.(check string)
    "printable" "\u{FFFD}"
    (Sources.quote (source "\x00") (span 0 1))

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
        Sources.excerpt (source text) (span start (start + length))
      in
      if length = 0 then marked = 1
      else String.sub line before marked = String.sub text start length)

let suite =
  ( "Sources",
    [
      Alcotest.test_case "place" `Quick test_place;
      Alcotest.test_case "excerpt" `Quick test_excerpt;
      Alcotest.test_case "excerpt of a long line" `Quick test_long_line;
      Alcotest.test_case "name and text" `Quick test_name;
      Alcotest.test_case "quote" `Quick test_quote;
      Alcotest.test_case "two files" `Quick test_two_files;
      Alcotest.test_case "digest" `Quick test_digest;
      marks_the_span;
    ] )
