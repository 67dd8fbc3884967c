(* doc/language.md becomes raylab-scene(5): how each block does. *)

open Raylab_manual

let lines page = String.split_on_char '\n' page

let page what markdown expected =
  match Markdown.parse (lines markdown) with
  | Ok blocks ->
      Alcotest.(check (list string)) what expected (Roff.lines blocks)
  | Error message -> Alcotest.fail message

let refused what markdown expected =
  let result = Result.map Roff.lines (Markdown.parse (lines markdown)) in
  Alcotest.(check (result (list string) string)) what (Error expected) result

let test_prose () =
  page "paragraphs" "one\ntwo\n\nthree" [ "one two"; ".PP"; "three" ];
  page "code" "a `b -1 'c'` d-e" [ {|a \fBb \-1 \(aqc\(aq\fR d-e|} ];
  page "strong" "**a** b" [ {|\fBa\fR b|} ];
  page "links" "[a `b`](c.md) [d][e]\n\n[e]: f" [ {|a \fBb\fR d|} ];
  page "a picture" "![a ball][b]\n\n[b]: c/d.png"
    [ "Picture c/d.\\&png: a ball" ];
  page "items" "- one\n  two\n- three"
    [ {|.IP \(bu 2|}; "one two"; {|.IP \(bu 2|}; "three" ]

let test_characters () =
  page "no requests" ".5 is" [ {|\&.5 is|} ];
  page "none in code" "    'a\n    .b"
    [ ".in +4n"; ".nf"; {|\(aqa|}; {|\&.\&b|}; ".fi"; ".in" ];
  page "marks" {|`\"^~`|} [ {|\fB\(rs\(dq\(ha\(ti\fR|} ];
  page "not ASCII" "d²" [ {|d\[u00B2]|} ]

let test_width () =
  let word = String.make 30 'x' in
  page "lines"
    (String.concat " " [ word; word; word ])
    [ word ^ " " ^ word; word ]

let test_headings () =
  page "levels" "# a\n## a `bC`\n### d\n\ne"
    [ {|.SH "A bC"|}; {|.SS "d"|}; "e" ];
  page "code below" "## a\n```sh\n$ b\n\nc\n```\nd"
    [
      {|.SH "A"|}; ".in +4n"; ".nf"; {|$ b|}; ""; "c"; ".fi"; ".in"; ".PP"; "d";
    ]

let test_tables () =
  page "cells"
    "| a | b | c | d |\n| --- | --- | --- | --- |\n| `1` | 2 | | 4 |"
    [ ".TP"; {|\fB1\fR|}; "2"; ".br"; "d: 4" ];
  page "pictures"
    "| `a` | b |\n| --- | --- |\n| ![][c] | ![](d.png) |\n\n[c]: c.png"
    [
      ".TP"; {|\fBa\fR|}; {|picture c.\&png|}; ".TP"; "b"; {|picture d.\&png|};
    ]

let test_refused () =
  refused "code without end" "a\n\n`b" "line 3: a ` is missing";
  refused "a block without end" "```\na" "line 1: there is no ``` at its end";
  refused "a link to nowhere" "a\n[b][c]" "line 1: nothing says where [c] goes";
  refused "no link" "a [b] c" "line 1: a link goes nowhere";
  refused "HTML" "a <b>" "line 1: < stands for itself only in backquotes";
  refused "a list with numbers" "1. a" "line 1: lists have no numbers here";
  refused "a table without header" "| a |\n| b |"
    "line 1: a table has no header";
  refused "a ragged table" "| a |\n| --- |\n| b | c |"
    "line 1: a row of a table has not as many cells as its header"

let () =
  Alcotest.run "manual"
    [
      ( "Page",
        [
          Alcotest.test_case "prose" `Quick test_prose;
          Alcotest.test_case "characters" `Quick test_characters;
          Alcotest.test_case "width" `Quick test_width;
          Alcotest.test_case "headings" `Quick test_headings;
          Alcotest.test_case "tables" `Quick test_tables;
          Alcotest.test_case "refused" `Quick test_refused;
        ] );
    ]
