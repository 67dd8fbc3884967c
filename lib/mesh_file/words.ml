open Raylab_source

type t = {
  text : string;
  bytes : bytes; (* the same, for Decimal *)
  mutable at : int; (* where to look for the next word *)
  mutable line : int;
  mutable first : int; (* of the word *)
  mutable stop : int;
}

let start ?(at = 0) ?(line = 1) text =
  let bytes = Bytes.unsafe_of_string text in
  { text; bytes; at; line; first = at; stop = at }

let line words = words.line
let place words = Fault.Line words.line
let length words = String.length words.text

(* {1 From word to word} *)

(* The place after the line end at [at]. *)
let after_line_end words at =
  if
    words.text.[at] = '\r'
    && at + 1 < length words
    && words.text.[at + 1] = '\n'
  then at + 2
  else at + 1

let rec line_end words at =
  if at >= length words then at
  else
    match String.unsafe_get words.text at with
    | '\n' | '\r' -> at
    | _ -> line_end words (at + 1)

let next_line words =
  let stop = line_end words words.at in
  if stop >= length words then (
    words.at <- stop;
    false)
  else (
    words.at <- after_line_end words stop;
    words.line <- words.line + 1;
    true)

let is_blank = function ' ' | '\t' | '\011' | '\012' -> true | _ -> false

(* Where the next line starts, if only a line end follows. *)
let continued words at =
  let rec blanks at =
    if at < length words && is_blank words.text.[at] then blanks (at + 1)
    else at
  in
  let at = blanks (at + 1) in
  if at < length words && (words.text.[at] = '\n' || words.text.[at] = '\r')
  then Some (after_line_end words at)
  else None

let rec word_end words at =
  if at >= length words then at
  else
    match String.unsafe_get words.text at with
    | ' ' | '\t' | '\011' | '\012' | '\n' | '\r' -> at
    | '\\' when Option.is_some (continued words at) -> at
    | _ -> word_end words (at + 1)

let take words at =
  words.first <- at;
  words.stop <- word_end words at;
  words.at <- words.stop;
  true

let rec next words =
  let at = words.at in
  if at >= length words then false
  else
    match String.unsafe_get words.text at with
    | ' ' | '\t' | '\011' | '\012' ->
        words.at <- at + 1;
        next words
    | '\n' | '\r' | '#' -> false
    | '\\' -> (
        match continued words at with
        | Some start ->
            words.at <- start;
            words.line <- words.line + 1;
            next words
        | None -> take words at)
    | _ -> take words at

let rec next_anywhere words =
  next words || (next_line words && next_anywhere words)

let back words = words.at <- words.first
let position words = words.at
let left words = length words - words.at

(* {1 The word} *)

let raw words = String.sub words.text words.first (words.stop - words.first)

let is words word =
  let count = String.length word in
  words.stop - words.first = count
  &&
  let rec same k =
    k = count
    || Char.lowercase_ascii words.text.[words.first + k] = word.[k]
       && same (k + 1)
  in
  same 0

let longest = 30

let text words =
  let count = words.stop - words.first in
  if count <= longest then
    "'" ^ Printable.text (String.sub words.text words.first count) ^ "'"
  else
    "'" ^ Printable.text (String.sub words.text words.first longest) ^ "...'"

(* {1 Numbers} *)

let is_digit c = '0' <= c && c <= '9'

let rec digits words at =
  if at < words.stop && is_digit (String.unsafe_get words.text at) then
    digits words (at + 1)
  else at

let sign words at =
  if at < words.stop && (words.text.[at] = '-' || words.text.[at] = '+') then
    at + 1
  else at

(* Whether the word is a sign, digits with or without a point, an exponent. *)
let is_decimal words =
  let start = sign words words.first in
  let whole = digits words start in
  let point = whole < words.stop && words.text.[whole] = '.' in
  let stop = if point then digits words (whole + 1) else whole in
  let some_digit = stop - start > if point then 1 else 0 in
  some_digit
  && (stop = words.stop
     || (words.text.[stop] = 'e' || words.text.[stop] = 'E')
        &&
        let first = sign words (stop + 1) in
        first < words.stop && digits words first = words.stop)

let number words =
  if not (is_decimal words) then
    Fault.fail (place words) "%s is no number" (text words);
  let x = Decimal.of_bytes words.bytes ~first:words.first ~stop:words.stop in
  if not (Float.is_finite x) then
    Fault.fail (place words) "%s is too large" (text words);
  x

let next_number words what =
  if not (next words) then Fault.fail (place words) "%s is missing" what;
  number words

let missing = min_int
let max_digits = 9

let integer_in words first stop =
  let start = if first < stop then sign words first else first in
  let rec value at sum =
    if at = stop then sum
    else
      let c = words.text.[at] in
      if not (is_digit c) then
        Fault.fail (place words) "%s is no whole number" (text words);
      value (at + 1) ((10 * sum) + Char.code c - Char.code '0')
  in
  if start = stop then
    Fault.fail (place words) "%s is no whole number" (text words);
  if stop - start > max_digits then
    Fault.fail (place words) "%s is too large" (text words);
  let sum = value start 0 in
  if words.text.[first] = '-' then -sum else sum

let integer words = integer_in words words.first words.stop

let integers words ~separator ints =
  Growing.Ints.clear ints;
  let rec from first =
    let rec find at =
      if at < words.stop && words.text.[at] <> separator then find (at + 1)
      else at
    in
    let stop = find first in
    Growing.Ints.add ints
      (if stop = first then missing else integer_in words first stop);
    if stop < words.stop then from (stop + 1)
  in
  from words.first
