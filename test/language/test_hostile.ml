(* Whatever the bytes, the result is a scene or errors with places in the text,
   never an exception; and what is printed about it reaches no control of the
   terminal. *)

open Raylab_language
open Test_support

let printed_is_clean error =
  let text = Property.show Scene_error.pp error in
  String.is_valid_utf_8 text
  && String.for_all (fun c -> c >= ' ' || c = '\n') text
  && not (String.contains text '\x7f')

let lines text =
  (* each character once: CR LF becomes LF, and then CR becomes LF *)
  let pieces = String.split_on_char '\r' text in
  let joined k piece =
    if k > 0 && not (String.starts_with ~prefix:"\n" piece) then "\n" ^ piece
    else piece
  in
  String.split_on_char '\n' (String.concat "" (List.mapi joined pieces))

let place_is_inside lines { Scene_error.place; _ } =
  match place with
  | None -> false
  | Some { line; first; last } ->
      1 <= line
      && line <= List.length lines
      && 1 <= first && first <= last
      (* one column after the line is where what is missing would stand *)
      && last <= String.length (List.nth lines (line - 1)) + 1

let is_scene_or_errors text =
  match Read.result text with
  | Ok _ -> true
  | Error errors ->
      let lines = lines text in
      errors <> []
      && List.for_all (place_is_inside lines) errors
      && List.for_all printed_is_clean errors

let holds name gen =
  Property.holds name ~count:3000 ~print:String.escaped gen is_scene_or_errors

let random_bytes = holds "random bytes" QCheck2.Gen.(string_size (0 -- 60))

let words =
  List.map fst Keyword.all
  @ [ "0"; "1"; "-1"; ".5"; "1e999"; "1e-999"; "1.2.3"; "2147483648" ]
  @ [ "("; ")"; "["; "]"; "="; ","; ":"; "+"; "-"; "*"; "/"; "^"; "<"; ">=" ]
  @ [
      "a"; "b"; "f("; "a("; "\"t\""; "\""; "p.x"; "and"; "not"; "then"; "true";
    ]
  @ [
      "difuse";
      "shpere";
      "#";
      "# x\n";
      "\n";
      "\r\n";
      "\r";
      "# x\r";
      "\t";
      "\x00";
    ]
  @ [ "\xff"; "\xc3\xa9"; "\xef\xbb\xbf"; "\x1b[31m"; "\u{202E}" ]

let soup =
  QCheck2.Gen.(map (String.concat " ") (list_size (0 -- 40) (oneofl words)))

let token_soup = holds "words in any order" soup

let soup_after_header =
  holds "words in any order after a header"
    (QCheck2.Gen.map Read.with_header soup)

(* Scenes that are right but for one byte. *)
let damaged =
  let open QCheck2.Gen in
  let* scene = Generate.scene Generate.everyday
  and* at = float_bound_exclusive 1.
  and* byte = char in
  let text = Bytes.of_string (Format.asprintf "%a" Scene_file.print scene) in
  Bytes.set text (int_of_float (at *. float_of_int (Bytes.length text))) byte;
  pure (Bytes.to_string text)

let one_wrong_byte = holds "one wrong byte" damaged

let cut_short =
  let open QCheck2.Gen in
  holds "a scene that ends too early"
    (map2
       (fun scene at ->
         let text = Format.asprintf "%a" Scene_file.print scene in
         String.sub text 0
           (int_of_float (at *. float_of_int (String.length text))))
       (Generate.scene Generate.everyday)
       (float_bound_exclusive 1.))

let times n text = String.concat "" (List.init n (fun _ -> text))
let check what text = Alcotest.(check bool) what true (is_scene_or_errors text)

(* However deep mixes are nested, nothing recurses on that: of the mix after
   1,000 its place is told. *)
let test_deep () =
  let deep = "sphere 0 0 6 1 " ^ times 200_000 "mixed 1 " in
  check "mixes that end well" (Read.with_header (deep ^ "reflective"));
  check "mixes that do not end" (Read.with_header deep);
  check "mixes in error" (Read.with_header (deep ^ "difuse"));
  check "a weight in error" (Read.with_header (deep ^ "mixed -1 reflective"));
  match Read.errors (Read.with_header (deep ^ "reflective")) with
  | [ { place = Some { line; first; last }; message; _ } ] ->
      Alcotest.(check string)
        "message" "mixes are nested deeper than 1,000" message;
      Alcotest.(check (triple int int int))
        "the 1001st mix" (2, 8016, 8020) (line, first, last)
  | errors -> Alcotest.failf "not one error: %s" (Read.show_errors errors)

let test_long () =
  check "a mix of many parts"
    (Read.with_header ("sphere 0 0 6 1 mixed" ^ times 200_000 " 1 reflective"));
  check "many objects"
    (Read.with_header (times 100_000 "sphere 0 0 6 1 reflective\n"));
  check "a long word" (String.make 1_000_000 'm');
  check "a long number" ("imWidth " ^ String.make 1_000_000 '1');
  check "a long comment" ("#" ^ String.make 1_000_000 'm');
  check "empty lines" (String.make 1_000_000 '\n');
  check "empty lines of another kind" (String.make 1_000_000 '\r');
  check "NUL" (String.make 1_000_000 '\x00')

(* Each error has its own excerpt. *)
let test_many_errors () =
  let wrong = "sphere 0 0 6 -1 reflective" in
  let count text = List.length (Read.errors (Read.with_header text)) in
  Alcotest.(check int)
    "a line each" 20_000
    (count (times 20_000 (wrong ^ "\n")));
  Alcotest.(check int) "on one line" 1000 (count (times 1000 (wrong ^ " ")))

(* A file with nothing but errors must not fill memory with their reports. *)
let test_errors_beyond () =
  let text = "sphere 0 0 6 1 mixed" ^ times 105_000 " -1 reflective" in
  let errors = Read.errors (Read.with_header text) in
  Alcotest.(check int) "not all" 100_001 (List.length errors);
  Alcotest.(check string)
    "how many more" "5000 more errors, the first of them here"
    (List.nth errors 100_000).message

let suite =
  ( "Hostile",
    [
      random_bytes;
      token_soup;
      soup_after_header;
      one_wrong_byte;
      cut_short;
      Alcotest.test_case "deep" `Quick test_deep;
      Alcotest.test_case "long" `Quick test_long;
      Alcotest.test_case "many errors" `Quick test_many_errors;
      Alcotest.test_case "more errors than are told" `Quick test_errors_beyond;
    ] )
