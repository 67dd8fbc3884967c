(* {1 Characters} *)

(* In code a hyphen is a minus, and never the end of a line; and nothing is the
   end of a sentence, after which man has its own idea of blanks. *)
let special ~code = function
  | '\\' -> "\\(rs"
  | '\'' -> "\\(aq"
  | '"' -> "\\(dq"
  | '`' -> "\\(ga"
  | '^' -> "\\(ha"
  | '~' -> "\\(ti"
  | '-' when code -> "\\-"
  | ('.' | '?' | '!') as stop when code -> Printf.sprintf "%c\\&" stop
  | char -> String.make 1 char

let escaped ~code text =
  let buffer = Buffer.create (String.length text) in
  let rec add i =
    if i < String.length text then (
      let decoded = String.get_utf_8_uchar text i in
      let uchar = Uchar.utf_decode_uchar decoded in
      Buffer.add_string buffer
        (if Uchar.to_int uchar < 128 then special ~code (Uchar.to_char uchar)
         else Printf.sprintf "\\[u%04X]" (Uchar.to_int uchar));
      add (i + Uchar.utf_decode_length decoded))
  in
  add 0;
  Buffer.contents buffer

(* {1 Prose} *)

let piece : Prose.piece -> string = function
  | Plain text -> escaped ~code:false text
  | Code text | Strong text -> "\\fB" ^ escaped ~code:true text ^ "\\fR"
  | Picture { shows = ""; file } -> "picture " ^ escaped ~code:true file
  | Picture { shows; file } ->
      Printf.sprintf "Picture %s: %s" (escaped ~code:true file)
        (escaped ~code:false shows)

(* Some characters would make a request of the line that starts with them. *)
let line text =
  match if text = "" then ' ' else text.[0] with
  | '.' | '\'' -> "\\&" ^ text
  | _ -> text

let width = 76

(* [filled words] is lines of at most [width] characters, if no word is
   longer. *)
let filled words =
  let add (lines, line) word =
    if line = "" then (lines, word)
    else if String.length line + 1 + String.length word <= width then
      (lines, line ^ " " ^ word)
    else (line :: lines, word)
  in
  let lines, line = List.fold_left add ([], "") words in
  List.rev (line :: lines)

let prose text =
  String.concat "" (List.map piece text)
  |> String.map (function '\n' -> ' ' | char -> char)
  |> String.split_on_char ' '
  |> List.filter (( <> ) "")
  |> filled |> List.map line

(* {1 Blocks} *)

let title level text =
  let words : Prose.piece -> string = function
    | Plain words when level = 2 -> String.uppercase_ascii words
    | Plain words | Code words | Strong words -> words
    | Picture { shows; _ } -> shows
  in
  escaped ~code:true (String.concat "" (List.map words text))

let heading level text =
  match level with
  | 1 -> []
  | 2 -> [ Printf.sprintf ".SH \"%s\"" (title level text) ]
  | _ -> [ Printf.sprintf ".SS \"%s\"" (title level text) ]

let verbatim text =
  let text = List.map (fun text -> line (escaped ~code:true text)) text in
  (".in +4n" :: ".nf" :: text) @ [ ".fi"; ".in" ]

let item text = ".IP \\(bu 2" :: prose text

(* [tagged tag texts] is [tag] at the margin, and each of [texts] below it. *)
let tagged tag texts =
  let below k text = if k = 0 then prose text else ".br" :: prose text in
  (".TP" :: prose tag) @ List.concat (List.mapi below texts)

let is_picture : Prose.t -> bool = function
  | [ Picture _ ] -> true
  | _ -> false

let named title cell = title @ (Prose.Plain ": " :: cell)

let row header cells =
  match (header, cells) with
  | _ when List.for_all is_picture cells ->
      List.concat
        (List.map2 (fun tag cell -> tagged tag [ cell ]) header cells)
  | _ :: _ :: titles, tag :: first :: others ->
      List.combine titles others
      |> List.filter (fun (_, cell) -> cell <> [])
      |> List.map (fun (title, cell) -> named title cell)
      |> List.cons first |> tagged tag
  | _ -> List.concat_map (fun tag -> tagged tag []) cells

let block : Markdown.block -> string list = function
  | Heading (level, text) -> heading level text
  | Paragraph text -> prose text
  | Verbatim text -> verbatim text
  | Items texts -> List.concat_map item texts
  | Table { header; rows } -> List.concat_map (row header) rows

(* After a heading, .PP would be one too many. *)
let rec from_heading = function
  | (Markdown.Heading _ as heading) :: rest ->
      block heading @ from_heading rest
  | next :: rest -> block next @ from_block rest
  | [] -> []

and from_block = function
  | ((Paragraph _ | Verbatim _) as next) :: rest ->
      (".PP" :: block next) @ from_block rest
  | ((Items _ | Table _) as next) :: rest -> block next @ from_block rest
  | rest -> from_heading rest

let lines = from_heading
