(* The places of errors of syntax, marked below the lines. How the whole
   messages look is in errors/. *)

let check = Read.check_errors

let test_words () =
  check "the first of two"
    {|
imWidth 4
sphere 0 0 6 1 difuse red
               ^^^^^^ unknown surface 'difuse'
sphere 0 0 6 1 misced
|};
  check "at once" {|
imwith 4
^^^^^^ unknown keyword 'imwith'
|};
  check "no number" {|
imWidth 1.2.3
        ^^^^^ '1.2.3' is not a number
|}

(* Columns count bytes: the e with its accent has two. A byte-order mark is no
   part of the text. *)
let test_bytes () =
  Read.check_errors "after other letters"
    "\n# \xc3\xa9\nimWidth 4 \xc3\xa9\n          ^^ unknown keyword '\xc3\xa9'";
  Read.check_errors "after a byte order mark"
    "\n\xef\xbb\xbffoo\n^^^ unknown keyword 'foo'";
  Read.check_errors "after a tab" "\n\tfoo\n ^^^ unknown keyword 'foo'";
  Read.check_errors "before a CR" "\nfoo\r\n^^^ unknown keyword 'foo'"

let test_lines () =
  let check what text expected =
    match (List.hd (Read.errors text)).place with
    | Some { line; first; _ } ->
        Alcotest.(check (pair int int)) what expected (line, first)
    | None -> Alcotest.fail "no place"
  in
  check "CR" "imWidth 4 # one\r# two\rimHeight x" (3, 10);
  check "CR LF" "imWidth 4 # one\r\n# two\r\nimHeight x" (3, 10);
  (* of a number that is checked later, found by going over the words again *)
  check "a number"
    (Read.with_header "sphere 0 0 # 6 1\r 6 -1 reflective")
    (3, 4)

let test_end () =
  check "of a line"
    {|
imWidth
       ^ the file ends where a number should follow|};
  check "after a line end"
    {|
imWidth

^ the file ends where a number should follow|};
  check "in a comment"
    {|
imWidth # 4
           ^ the file ends where a number should follow|}

let suite =
  ( "Error places",
    [
      Alcotest.test_case "words" `Quick test_words;
      Alcotest.test_case "bytes" `Quick test_bytes;
      Alcotest.test_case "the end" `Quick test_end;
      Alcotest.test_case "lines" `Quick test_lines;
    ] )
