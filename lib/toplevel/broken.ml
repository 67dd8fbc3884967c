(* [pp] may have breaks of its own: they are not to be taken. *)
let one_line pp value =
  let buffer = Buffer.create 80 in
  let ppf = Format.formatter_of_buffer buffer in
  Format.pp_set_margin ppf 1_000_000_000;
  Format.fprintf ppf "%a@?" pp value;
  Buffer.contents buffer

let is_letter = function 'a' .. 'z' | 'A' .. 'Z' -> true | _ -> false
let is_word text = text <> "" && (is_letter text.[0] || text.[0] = '[')
let is_operator text = List.mem text [ "+"; "*"; "=" ]

(* How many parentheses [text] opens, less those that it closes. Those around
   words keep nothing together. *)
let opened text =
  let add n = function '(' -> n + 1 | ')' -> n - 1 | _ -> n in
  if String.length text > 1 && text.[0] = '(' && is_letter text.[1] then 0
  else String.fold_left add 0 text

(* [depth] parentheses are open, and [before] was printed last. *)
let rec pp_rest ppf depth before = function
  | [] -> ()
  | text :: rest ->
      let begins_word =
        is_word text
        || is_operator text
           && match rest with next :: _ -> is_word next | [] -> false
      in
      if depth = 0 && begins_word && not (is_operator before) then
        Format.pp_print_space ppf ()
      else Format.pp_print_char ppf ' ';
      Format.pp_print_string ppf text;
      pp_rest ppf (Int.max 0 (depth + opened text)) text rest

let pp_line ppf line =
  match String.split_on_char ' ' line with
  | [] -> ()
  | first :: rest ->
      Format.fprintf ppf "@[<hov 2>%s" first;
      pp_rest ppf (opened first) first rest;
      Format.fprintf ppf "@]"

let at_words pp ppf value =
  let lines = String.split_on_char '\n' (one_line pp value) in
  Format.fprintf ppf "@[<v>%a@]" (Format.pp_print_list pp_line) lines
