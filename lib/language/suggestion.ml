let is_number word =
  match Lexer.token (Lexer.start ()) (Lexing.from_string word) with
  | NUMBER _ -> true
  | _ -> false

(* Longer ones are not repeated. *)
let longest = 40

(* [1,5] has a decimal comma. Other commas are between numbers. *)
let without_commas word =
  if String.length word > longest then None
  else
    let text =
      match String.split_on_char ',' word with
      | [ whole; decimals ] when whole <> "" && decimals <> "" ->
          whole ^ "." ^ decimals
      | pieces -> String.concat " " (List.filter (( <> ) "") pieces)
    in
    if List.for_all is_number (String.split_on_char ' ' text) then Some text
    else None

let quoted_list words =
  match List.rev_map (Printf.sprintf "'%s'") words with
  | [] -> ""
  | [ word ] -> word
  | last :: before -> String.concat ", " (List.rev before) ^ " or " ^ last

let did_you_mean words = Printf.sprintf "Did you mean %s?" (quoted_list words)

let of_trade ~acceptable keywords =
  match List.filter acceptable keywords with
  | [] -> Printf.sprintf "The language calls that %s." (quoted_list keywords)
  | here -> did_you_mean here

let nearest ~acceptable ~names word =
  let words = names @ List.filter acceptable (List.map fst Keyword.all) in
  match Keyword.nearest word ~among:words with
  | Some keyword -> did_you_mean [ keyword ]
  | None -> ""

let sentence ~acceptable ~names word =
  let word = Lookalike.plain word in
  let keyword_acceptable keyword =
    Option.fold ~none:false ~some:acceptable (Keyword.token keyword)
  in
  let names = if acceptable (NAME "") then names else [] in
  let numbers = if acceptable (NUMBER 0.) then without_commas word else None in
  match (numbers, Synonym.keywords word) with
  | Some numbers, _ -> did_you_mean [ numbers ]
  | None, [] -> nearest ~acceptable:keyword_acceptable ~names word
  | None, keywords -> of_trade ~acceptable:keyword_acceptable keywords
