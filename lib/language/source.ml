open Raylab_source

type t = { name : string; text : string; lines : Lines.t Lazy.t }

let printable text =
  let out = Buffer.create (String.length text) in
  let rec copy i =
    if i < String.length text then (
      let decoded = String.get_utf_8_uchar text i in
      let code = Uchar.to_int (Uchar.utf_decode_uchar decoded) in
      if code = 0x09 then Buffer.add_char out ' '
      else if
        Character.is_unseen code || not (Uchar.utf_decode_is_valid decoded)
      then Buffer.add_utf_8_uchar out Uchar.rep
      else Buffer.add_utf_8_uchar out (Uchar.of_int code);
      copy (i + Uchar.utf_decode_length decoded))
  in
  copy 0;
  Buffer.contents out

let byte_order_mark = "\xef\xbb\xbf"

let make ~name text =
  let text =
    if String.starts_with ~prefix:byte_order_mark text then
      let n = String.length byte_order_mark in
      String.sub text n (String.length text - n)
    else text
  in
  { name = printable name; text; lines = lazy (Lines.index text) }

let name source = source.name
let text source = source.text

(* The line on which [span] starts. *)
let line_of source span = Lines.at (Lazy.force source.lines) (Span.start span)

type place = { line : int; first : int; last : int }

let place source span =
  let { Lines.number; start; stop } = line_of source span in
  let first = Span.start span - start + 1 in
  let last = Int.min (Span.stop span) stop - start in
  { line = number + 1; first; last = Int.max first last }

let longest_quote = 40

let slice source span =
  let start = Span.start span in
  String.sub source.text start (Span.stop span - start)

let quote source span =
  let start = Span.start span in
  if Span.stop span - start <= longest_quote then printable (slice source span)
  else printable (String.sub source.text start longest_quote) ^ "..."

let next_word source offset =
  let text = source.text in
  let length = String.length text in
  let is_blank c = String.contains " \t\r\n\011\012" c in
  let rec skip holds i =
    if i < length && holds text.[i] then skip holds (i + 1) else i
  in
  let rec find i =
    let start = skip is_blank i in
    if start < length && text.[start] = '#' then
      find (skip (fun c -> c <> '\n' && c <> '\r') start)
    else
      let stop = skip (fun c -> not (is_blank c || c = '#')) start in
      Span.make ~start ~stop
  in
  find offset

let widest_excerpt = 72

let characters text =
  let count n c = if Char.code c land 0xc0 = 0x80 then n else n + 1 in
  String.fold_left count 0 text

let excerpt source span =
  let { Lines.start; stop; _ } = line_of source span in
  let from, until =
    if stop - start <= widest_excerpt then (start, stop)
    else
      let from = Int.max start (Span.start span - (widest_excerpt / 2)) in
      (from, Int.min stop (from + widest_excerpt))
  in
  let piece a b = printable (String.sub source.text a (Int.max 0 (b - a))) in
  let cut_before = if from > start then "..." else ""
  and cut_after = if until < stop then "..." else ""
  and marked_stop = Int.min until (Span.stop span) in
  let before = cut_before ^ piece from (Span.start span)
  and marked = piece (Span.start span) marked_stop
  and after = piece marked_stop until ^ cut_after in
  (before ^ marked ^ after, characters before, Int.max 1 (characters marked))
