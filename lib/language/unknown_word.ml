open Raylab_source
open Raylab_scene

(* {1 A character that does not belong} *)

let span_of word_span { Lookalike.start; stop; _ } =
  let offset = word_span.Span.start in
  { Span.start = offset + start; stop = offset + stop }

let character_error sources word_span found =
  let { Lookalike.name; meant; _ } = found in
  let message, advice =
    match meant with
    | "" -> (name ^ ", is not seen, and belongs to no word", "remove it")
    | " " -> (name ^ ", separates no words", "write an ordinary space instead")
    | meant ->
        ( Printf.sprintf "%s, is not '%s'" name meant,
          Printf.sprintf "write '%s' instead" meant )
  in
  Scene_error.make sources (span_of word_span found) message ~advice

(* Whether the language knows all words of [text]. *)
let is_known text =
  let lexbuf = Lexing.from_string text and words = Lexer.start () in
  let rec rest () =
    match Lexer.token words lexbuf with
    | EOF -> true
    | WORD _ | STRING _ -> false
    | _ -> rest ()
  in
  rest ()

(* {1 A word} *)

let names_of_colors =
  match List.rev_map fst Color.names with
  | last :: before ->
      Printf.sprintf "\nThe names are %s and %s."
        (String.concat ", " (List.rev before))
        last
  | [] -> ""

let character_told sources word_span found =
  let place = Sources.place sources (span_of word_span found) in
  Printf.sprintf " There is %s, in column %d." found.name place.first

let word_error sources span ~acceptable ~names:known ~expected ~advice ~habit
    word =
  let quoted = Sources.quote sources span in
  let message =
    if expected.[0] = '\'' then
      Printf.sprintf "%s should stand here, not '%s'" expected quoted
    else if List.mem expected [ "number"; "name"; "condition"; "operator" ]
    then
      Printf.sprintf "'%s' is %s %s" quoted
        (if expected = "operator" then "no" else "not a")
        expected
    else Printf.sprintf "unknown %s '%s'" expected quoted
  and names = if expected = "colour" then names_of_colors else ""
  and character =
    Option.fold ~none:""
      ~some:(character_told sources span)
      (Lookalike.first word)
  and suggestion =
    if habit <> "" then habit
    else
      match Suggestion.sentence ~acceptable ~names:known word with
      | "" -> ""
      | sentence -> " " ^ sentence
  in
  Scene_error.make sources span message
    ~advice:(advice ^ names ^ character ^ suggestion)

let error sources span ~acceptable ~names ~expected ~advice ~habit =
  let word = Sources.slice sources span in
  match Lookalike.first word with
  | Some found when is_known (Lookalike.plain word) ->
      character_error sources span found
  | _ ->
      word_error sources span ~acceptable ~names ~expected ~advice ~habit word
