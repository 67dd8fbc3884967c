open Raylab_source

let look index offset =
  let { Lines.number; start; next } = Lines.at index offset in
  (number, start, next)

let line text offset = look (Lines.index text) offset

(* What [Lines.at] is, by cutting the text into lines, one end after another. *)
let slow text offset =
  let length = String.length text in
  let rec cut number start =
    let rec find i =
      if i < length && text.[i] <> '\r' && text.[i] <> '\n' then find (i + 1)
      else i
    in
    let stop = find start in
    let is_crlf = stop + 1 < length && String.sub text stop 2 = "\r\n" in
    let next = stop + if is_crlf then 2 else 1 in
    if next > length then (number, start, length)
    else if offset < next then (number, start, next)
    else cut (number + 1) next
  in
  cut 0 0

let place = Alcotest.(triple int int int)

let test_few () =
  List.iter
    (fun text ->
      for offset = 0 to String.length text do
        Alcotest.check place (String.escaped text) (slow text offset)
          (line text offset)
      done)
    [
      ""; "\n"; "a"; "a\n"; "\na"; "ab\n\ncd\n"; "\n\n\n"; "\r"; "a\rb";
      "\r\n"; "ab\r\ncd\r\n"; "\n\r"; "a\r\r\nb"; "\r\n\r\n"; "a\n\rb\r";
    ]
[@@ocamlformat "disable"]

let test_ends () =
  let check what expected text offset =
    Alcotest.check place what expected (line text offset)
  in
  check "after CR" (1, 2, 3) "a\rb" 2;
  check "CR LF is one" (1, 3, 4) "a\r\nb" 3;
  check "the LF of CR LF is in the line that it ends" (0, 0, 3) "a\r\nb" 2;
  check "LF CR are two" (2, 3, 4) "a\n\rb" 3

(* Lines whose lengths take one, two and three bytes, and more lines than one
   counts from a place that is known. *)
let test_long () =
  let check line_end length =
    let line_of k = String.make (k * length mod (length + 7)) 'a' in
    let text = String.concat line_end (List.init 300 line_of) in
    let index = Lines.index text in
    let step = 1 + (String.length text / 20) in
    let offset = ref 0 in
    while !offset <= String.length text do
      Alcotest.check place "the same" (slow text !offset) (look index !offset);
      offset := !offset + step
    done
  in
  List.iter
    (fun line_end -> List.iter (check line_end) [ 1; 50; 126; 127; 128; 3000 ])
    [ "\n"; "\r"; "\r\n" ];
  let text = String.make 20_000 'a' ^ "\n" ^ String.make 3_000_000 'b' in
  Alcotest.check place "long" (0, 0, 20_001) (line text 20_000);
  Alcotest.check place "very long" (1, 20_001, 3_020_001) (line text 3_000_000)

let text =
  QCheck2.Gen.(string_size ~gen:(oneofl [ 'a'; '\n'; '\r' ]) (0 -- 20))

let of_any_text =
  Test_support.Property.holds "of any text" ~count:2000 ~print:String.escaped
    text (fun text ->
      let same offset = slow text offset = line text offset in
      List.for_all same (List.init (String.length text + 1) Fun.id))

(* A byte or two a line, and a little for what is known of every 128th. *)
let test_memory () =
  let check what bytes text =
    let words = Obj.reachable_words (Obj.repr (Lines.index text)) in
    Alcotest.(check bool) what true (8 * words < 200 + (bytes * 5 / 4))
  in
  check "nothing but line ends" 1_000_001 (String.make 1_000_000 '\n');
  check "one line" 3 (String.make 1_000_000 'a');
  let lines = String.concat "\n" (List.init 10_000 (fun _ -> "sphere")) in
  check "short lines" 10_000 lines

let test_as_data () =
  let index = Lines.index "a\nbc\n" in
  let copy = Marshal.from_string (Marshal.to_string index []) 0 in
  Alcotest.(check bool) "is data" true (copy = index);
  Alcotest.(check int) "length" 5 (Lines.length index)

let suite =
  ( "Lines",
    [
      Alcotest.test_case "memory" `Quick test_memory;
      Alcotest.test_case "as data" `Quick test_as_data;
      Alcotest.test_case "few" `Quick test_few;
      Alcotest.test_case "ends" `Quick test_ends;
      Alcotest.test_case "long" `Quick test_long;
      of_any_text;
    ] )
