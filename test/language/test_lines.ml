open Raylab_language

let line text offset =
  let { Lines.number; start; stop } = Lines.at (Lines.index text) offset in
  (number, start, stop)

(* What [Lines.at] is, by looking at every byte. *)
let slow text offset =
  let before = String.sub text 0 offset in
  let number =
    String.fold_left (fun n c -> if c = '\n' then n + 1 else n) 0 before
  in
  let start =
    match String.rindex_opt before '\n' with Some i -> i + 1 | None -> 0
  and stop =
    match String.index_from_opt text offset '\n' with
    | Some stop -> stop
    | None -> String.length text
  in
  (number, start, stop)

let place = Alcotest.(triple int int int)

let test_few () =
  List.iter
    (fun text ->
      for offset = 0 to String.length text do
        Alcotest.check place text (slow text offset) (line text offset)
      done)
    [ ""; "\n"; "a"; "a\n"; "\na"; "ab\n\ncd\n"; "\n\n\n" ]

(* Lines shorter and longer than the pieces in which the index looks. *)
let test_long () =
  List.iter
    (fun length ->
      let line_of k = String.make (k * length mod (length + 7)) 'a' in
      let text = String.concat "\n" (List.init 40 line_of) in
      let index = Lines.index text in
      let offset = ref 0 in
      while !offset <= String.length text do
        let { Lines.number; start; stop } = Lines.at index !offset in
        Alcotest.check place "the same" (slow text !offset)
          (number, start, stop);
        offset := !offset + 61
      done)
    [ 1; 50; 4095; 4096; 4097; 10_000 ]

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
    [ '\n'; 'a' ]

let suite =
  ( "Lines",
    [
      Alcotest.test_case "memory" `Quick test_memory;
      Alcotest.test_case "few" `Quick test_few;
      Alcotest.test_case "long" `Quick test_long;
    ] )
