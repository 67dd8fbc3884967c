open Raylab_source
open Raylab_scene

type t = string * int

let sentence (word, offset) =
  let text =
    Printf.sprintf
      "'%s' is a name from here to the end of its block, and no longer the \
       word of the language"
      word
  in
  { Warning.text; about = [ Literal offset ] }

(* [after prefix text] is what follows [prefix] and blanks in [text]. *)
let after prefix text =
  if String.starts_with ~prefix:(String.lowercase_ascii prefix) text then
    let length = String.length prefix in
    Some (String.trim (String.sub text length (String.length text - length)))
  else None

let used_in_definition sources ~before taken =
  let used (word, start) =
    if start >= before then None
    else
      let text = Sources.slice sources { Span.start; stop = before } in
      let value = Option.bind (after word (String.lowercase_ascii text)) in
      match value (after "=") with
      | Some rest when String.equal rest (String.lowercase_ascii word) ->
          let stop = start + String.length (String.trim text) in
          Some { Span.start = stop - String.length word; stop }
      | _ -> None
  in
  List.find_map used taken

let warnings taken = Warning.few "name" sentence taken
