type block =
  | Heading of int * Prose.t
  | Paragraph of Prose.t
  | Verbatim of string list
  | Items of Prose.t list
  | Table of { header : Prose.t list; rows : Prose.t list list }

let unknown what = raise (Prose.Unknown what)
let starts prefix line = String.starts_with ~prefix line
let is_blank line = String.trim line = ""

let without_first k line =
  let length = String.length line in
  String.sub line (Int.min k length) (Int.max 0 (length - k))

(* [span belongs lines] is the first lines, which belong, and the others. *)
let rec span belongs = function
  | line :: rest when belongs line ->
      let here, others = span belongs rest in
      (line :: here, others)
  | others -> ([], others)

(* {1 Blocks of prose} *)

let definition line =
  match
    Scanf.sscanf line "[%[^]]]: %s%!" (fun name target -> (name, target))
  with
  | definition -> Some definition
  | exception (Scanf.Scan_failure _ | End_of_file) -> None

let cells ~targets line =
  match List.rev (String.split_on_char '|' line) with
  | "" :: (_ :: _ as cells) when starts "|" line ->
      List.rev_map
        (fun cell -> Prose.parse ~targets (String.trim cell))
        (List.filteri (fun k _ -> k < List.length cells - 1) cells)
  | _ -> unknown "a row of a table has no | at its end"

let table ~targets = function
  | header :: line :: rows when starts "| --" line ->
      let header = cells ~targets header in
      let row line =
        let row = cells ~targets line in
        if List.compare_lengths row header <> 0 then
          unknown "a row of a table has not as many cells as its header";
        row
      in
      Table { header; rows = List.map row rows }
  | _ -> unknown "a table has no header"

let joined lines = String.concat "\n" (List.map String.trim lines)

let rec items ~targets = function
  | first :: rest ->
      let more, others = span (fun line -> not (starts "- " line)) rest in
      let lines = without_first 2 first :: more in
      Prose.parse ~targets (joined lines) :: items ~targets others
  | [] -> []

let is_numbered line =
  match String.index_opt line '.' with
  | Some i when i > 0 && starts ". " (without_first i line) ->
      String.for_all (fun c -> '0' <= c && c <= '9') (String.sub line 0 i)
  | _ -> false

let of_prose ~targets lines =
  match lines with
  | line :: _ when starts "|" line -> table ~targets lines
  | line :: _ when starts "- " line -> Items (items ~targets lines)
  | line :: _ when is_numbered line -> unknown "lists have no numbers here"
  | _ -> Paragraph (Prose.parse ~targets (joined lines))

(* {1 All blocks} *)

let heading ~targets line =
  let level = String.index line ' ' in
  let title = String.trim (without_first level line) in
  Heading (level, Prose.parse ~targets title)

let fenced rest =
  match span (( <> ) "```") rest with
  | lines, _ :: rest -> (Verbatim lines, rest)
  | _, [] -> unknown "there is no ``` at its end"

let indented lines =
  let lines, rest =
    span (fun line -> is_blank line || starts "    " line) lines
  in
  let rec without_last_blanks = function
    | blank :: others when is_blank blank -> without_last_blanks others
    | lines -> List.rev lines
  in
  let lines = without_last_blanks (List.rev lines) in
  (Verbatim (List.map (without_first 4) lines), rest)

let is_heading line =
  starts "# " line || starts "## " line || starts "### " line

let ends_prose line = is_blank line || is_heading line || starts "```" line

let block ~targets line rest =
  if is_heading line then (heading ~targets line, rest)
  else if starts "```" line then fenced rest
  else if starts "    " line then indented (line :: rest)
  else
    let lines, rest =
      span (fun line -> not (ends_prose line)) (line :: rest)
    in
    (of_prose ~targets lines, rest)

let parse lines =
  let targets = List.filter_map definition lines in
  let rec blocks parsed = function
    | [] -> Ok (List.rev parsed)
    | line :: rest when is_blank line || definition line <> None ->
        blocks parsed rest
    | line :: rest -> (
        match block ~targets line rest with
        | block, others -> blocks (block :: parsed) others
        | exception Prose.Unknown what ->
            let before = List.length lines - List.length rest - 1 in
            Error (Printf.sprintf "line %d: %s" (before + 1) what))
  in
  blocks [] lines
