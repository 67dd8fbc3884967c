open Raylab_language

let line text offset =
  let { Lines.number; start; stop } = Lines.at (Lines.index text) offset in
  (number, start, stop)

(* What [Lines.at] is, by cutting the text into lines, one end after another. *)
let slow text offset =
  let length = String.length text in
  let rec cut number start =
    let rec find i =
      if i < length && not (String.contains "\r\n" text.[i]) then find (i + 1)
      else i
    in
    let stop = find start in
    let is_crlf = stop + 1 < length && String.sub text stop 2 = "\r\n" in
    let next = stop + if is_crlf then 2 else 1 in
    if offset < next || next > length then (number, start, stop)
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
  check "the LF of CR LF is in the line that it ends" (0, 0, 1) "a\r\nb" 2;
  check "LF CR are two" (2, 3, 4) "a\n\rb" 3

(* Lines shorter and longer than the pieces in which the index looks. Where a
   piece begins in the middle of CR LF, that is still one end. *)
let test_long () =
  let check line_end length =
    let line_of k = String.make (k * length mod (length + 7)) 'a' in
    let text = String.concat line_end (List.init 12 line_of) in
    let index = Lines.index text in
    let step = 1 + (String.length text / 100) in
    let offset = ref 0 in
    while !offset <= String.length text do
      let { Lines.number; start; stop } = Lines.at index !offset in
      Alcotest.check place "the same" (slow text !offset) (number, start, stop);
      offset := !offset + step
    done
  in
  List.iter
    (fun line_end ->
      List.iter (check line_end) [ 1; 50; 4094; 4095; 4096; 4097; 10_000 ])
    [ "\n"; "\r"; "\r\n" ];
  let text = String.make 4095 'a' ^ "\r\nb" in
  Alcotest.check place "at a seam" (0, 0, 4095) (line text 4096);
  Alcotest.check place "after it" (1, 4097, 4098) (line text 4097)

let text =
  QCheck2.Gen.(string_size ~gen:(oneofl [ 'a'; '\n'; '\r' ]) (0 -- 20))

let of_any_text =
  Test_support.Property.holds "of any text" ~count:2000 ~print:String.escaped
    text (fun text ->
      let same offset = slow text offset = line text offset in
      List.for_all same (List.init (String.length text + 1) Fun.id))

(* Of any text, the one that is nothing but line ends included. *)
let test_memory () =
  let words value = Obj.reachable_words (Obj.repr value) in
  List.iter
    (fun char ->
      let text = String.make 1_000_000 char in
      let index = Lines.index text in
      Alcotest.(check bool)
        "some thousandths" true
        (words index - words text < words text / 100))
    [ '\n'; '\r'; 'a' ]

let suite =
  ( "Lines",
    [
      Alcotest.test_case "memory" `Quick test_memory;
      Alcotest.test_case "few" `Quick test_few;
      Alcotest.test_case "ends" `Quick test_ends;
      Alcotest.test_case "long" `Quick test_long;
      of_any_text;
    ] )
