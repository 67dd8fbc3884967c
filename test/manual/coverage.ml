(* coverage PAGE: every word of the scene language is in PAGE, a keyword in a
   heading, a function with its parameters and what it is; the words over a
   picture stand in the scene that it shows; every picture is shown; and what is
   called the same scene in other words is. *)

open Raylab_scene
open Raylab_language
open Raylab_expression

let contains text part =
  let length = String.length part in
  let is_at i = String.sub text i length = part in
  let last = String.length text - length in
  Seq.exists is_at (Seq.init (Int.max 0 (last + 1)) Fun.id)

let failed = ref false

let require truth format =
  Printf.ksprintf
    (fun complaint ->
      if not truth then (
        prerr_endline complaint;
        failed := true))
    format

let check_words lines =
  let headings = List.filter (String.starts_with ~prefix:"### ") lines in
  let check (word, token) =
    let places =
      match (token : Parser.token) with COLOR _ -> lines | _ -> headings
    in
    let quoted = Printf.sprintf "`%s`" word in
    require
      (List.exists (fun line -> contains line quoted) places)
      "the page has no %s" quoted
  in
  List.iter check Keyword.all;
  let has_constant (name, _, _) =
    let quoted = Printf.sprintf "`%s`" name in
    require
      (List.exists (fun line -> contains line quoted) lines)
      "the page has no %s" quoted
  in
  List.iter has_constant Builtin.constants

(* The rows of the table whose first column has this title. *)
let rec table title = function
  | head :: _ :: rows when String.starts_with ~prefix:("| " ^ title) head ->
      let is_row = String.starts_with ~prefix:"|" in
      List.of_seq (Seq.take_while is_row (List.to_seq rows))
  | _ :: rest -> table title rest
  | [] -> []

let check_functions lines =
  let row f = Printf.sprintf "| `%s` | %s |" (Builtin.usage f) f.Builtin.doc in
  let rows = table "function" lines and wanted = List.map row Builtin.all in
  List.iter
    (fun row -> require (List.mem row rows) "the page has no row %s" row)
    wanted;
  List.iter
    (fun row -> require (List.mem row wanted) "no function is: %s" row)
    rows

(* Line ends and blanks only separate words. *)
let normal text =
  String.map (fun c -> if c = '\n' then ' ' else c) text
  |> String.split_on_char ' '
  |> List.filter (( <> ) "")
  |> String.concat " "

let scene_file dir name =
  Filename.concat dir (Filename.concat "language" name ^ ".scene")

let check_picture dir words name =
  let text =
    In_channel.with_open_bin (scene_file dir name) In_channel.input_all
  in
  require (contains (normal text) words) "%s.scene does not say: %s" name words

(* A caption that is not in backquotes is no part of a scene. *)
let check_cell dir caption picture =
  match Scanf.sscanf caption " `%[^`]` %!" Fun.id with
  | words -> Scanf.sscanf picture " ![][%[^]]] %!" (check_picture dir words)
  | exception (Scanf.Scan_failure _ | End_of_file) -> ()

let check_used page line =
  match Scanf.sscanf line "[%[^]]]: language/" Fun.id with
  | name ->
      require
        (contains page (Printf.sprintf "][%s]" name))
        "%s is not shown" name
  | exception (Scanf.Scan_failure _ | End_of_file) -> ()

let check_same dir name name' =
  let load name = Result.get_ok (Scene_file.load (scene_file dir name)) in
  require
    (Scene.equal (load name) (load name'))
    "%s.scene and %s.scene are not the same scene" name name'

let cells = String.split_on_char '|'

let rec check_tables dir = function
  | captions :: _ :: pictures :: rest
    when String.starts_with ~prefix:"| ![][" pictures ->
      List.iter2 (check_cell dir) (cells captions) (cells pictures);
      check_tables dir rest
  | _ :: rest -> check_tables dir rest
  | [] -> ()

let () =
  let path = Sys.argv.(1) in
  let dir = Filename.dirname path in
  let lines = In_channel.with_open_bin path In_channel.input_lines in
  check_words lines;
  check_functions lines;
  check_tables dir lines;
  check_same dir "scene" "words";
  List.iter (check_used (String.concat "\n" lines)) lines;
  if !failed then exit 1
