(* The lengths of all lines, line ends included, each in bytes of 7 bits, the
   lowest first; all but its last byte have the high bit. Where every 128th line
   starts is known; from there on one counts. *)

type mark = { start : int; (* of the line *) at : int (* in [lengths] *) }
type t = { lengths : string; marks : mark array; length : int }

let length index = index.length
let lines_per_mark = 128

(* {1 Making one} *)

let rec add_length lengths n =
  if n < 0x80 then Buffer.add_uint8 lengths n
  else (
    Buffer.add_uint8 lengths (0x80 lor (n land 0x7f));
    add_length lengths (n lsr 7))

(* The line end that is at or after [i], or else [length], the text's. *)
let rec find_end text length i =
  if i = length then i
  else
    let c = String.unsafe_get text i in
    if c <= '\r' && (c = '\n' || c = '\r') then i
    else find_end text length (i + 1)

let after_end text i =
  let is_crlf =
    text.[i] = '\r' && i + 1 < String.length text && text.[i + 1] = '\n'
  in
  i + if is_crlf then 2 else 1

let index text =
  let length = String.length text and lengths = Buffer.create 1024 in
  let rec add marks number start =
    let marks =
      if number mod lines_per_mark = 0 then
        { start; at = Buffer.length lengths } :: marks
      else marks
    in
    let stop = find_end text length start in
    if stop = length then (
      add_length lengths (stop - start);
      marks)
    else
      let next = after_end text stop in
      add_length lengths (next - start);
      add marks (number + 1) next
  in
  let marks = Array.of_list (List.rev (add [] 0 0)) in
  { lengths = Buffer.contents lengths; marks; length }

(* {1 Asking it} *)

type line = { number : int; start : int; next : int }

(* The length that is written at [at], and where the one after it is. *)
let rec read lengths at shift n =
  let byte = String.get_uint8 lengths at in
  let n = n lor ((byte land 0x7f) lsl shift) in
  if byte < 0x80 then (n, at + 1) else read lengths (at + 1) (shift + 7) n

let rec count lengths at number start offset =
  let length, after = read lengths at 0 0 in
  let next = start + length in
  if offset < next || after = String.length lengths then
    { number; start; next }
  else count lengths after (number + 1) next offset

let at { lengths; marks; _ } offset =
  let k = Search.last_from (fun (mark : mark) -> mark.start) marks offset in
  let { start; at } = marks.(k) in
  count lengths at (k * lines_per_mark) start offset
