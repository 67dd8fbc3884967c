(* The grammars for editors have all words of the language, and no others. *)

open Raylab_language
open Raylab_expression

let read path = In_channel.with_open_bin path In_channel.input_all
let folder = "../../doc/editors/"

let words =
  List.map (fun { Keyword.word; _ } -> word) Keyword.table
  @ List.map (fun { Builtin.name; _ } -> name) Builtin.all
  @ List.map (fun (name, _, _) -> name) Builtin.constants
  @ [ "time" ]

let check what found =
  let sorted = List.sort_uniq String.compare in
  Alcotest.(check (list string)) what (sorted words) (sorted found)

let test_vim () =
  let keywords line =
    match String.split_on_char ' ' line with
    | "syntax" :: "keyword" :: "raylabTodo" :: _ -> []
    | "syntax" :: "keyword" :: _ :: words ->
        List.filter (( <> ) "contained") words
    | _ -> []
  in
  String.split_on_char '\n' (read (folder ^ "raylab.vim"))
  |> List.concat_map keywords |> check "words"

let rec patterns (json : Yojson.Safe.t) =
  match json with
  | `Assoc members ->
      List.concat_map
        (function
          | "match", `String pattern -> [ pattern ] | _, json -> patterns json)
        members
  | `List items -> List.concat_map patterns items
  | _ -> []

let opening = "(?i)(?<![\\w.])(?:"
let closing = ")(?!\\w)"

let test_textmate () =
  let keywords pattern =
    if String.starts_with ~prefix:opening pattern then
      let start = String.length opening in
      let length = String.length pattern - start - String.length closing in
      String.split_on_char '|' (String.sub pattern start length)
    else []
  in
  Yojson.Safe.from_file (folder ^ "raylab.tmLanguage.json")
  |> patterns |> List.concat_map keywords |> check "words"

let () =
  Alcotest.run "editors"
    [
      ( "Words",
        [
          Alcotest.test_case "Vim" `Quick test_vim;
          Alcotest.test_case "TextMate" `Quick test_textmate;
        ] );
    ]
