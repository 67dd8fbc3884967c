let prompt = "raylab # "
let is_prompt = String.starts_with ~prefix:prompt
let ends_phrase = String.ends_with ~suffix:";;"

(* A line of a page: kept, or typed and answered. *)
type item = Text of string | Phrase of string list

(* {1 Reading a page} *)

let rec read_phrase typed = function
  | line :: rest when ends_phrase line -> (List.rev (line :: typed), rest)
  | line :: rest -> read_phrase (line :: typed) rest
  | [] -> failwith "a phrase without end"

let rec skip_answer = function
  | line :: rest when not (is_prompt line || line = "```") -> skip_answer rest
  | lines -> lines

let rec read_text = function
  | "```ocaml" :: rest -> Text "```ocaml" :: read_block rest
  | line :: rest -> Text line :: read_text rest
  | [] -> []

and read_block = function
  | "```" :: rest -> Text "```" :: read_text rest
  | line :: _ as lines when is_prompt line ->
      let typed, rest = read_phrase [] lines in
      Phrase typed :: read_block (skip_answer rest)
  | _ -> failwith "a block of ocaml does not start with the prompt"

(* {1 Running the phrases} *)

(* No answer has this character. *)
let mark = '\x1f'

let input_of_phrase lines =
  let text = String.concat "\n" lines in
  let skip = String.length prompt in
  Printf.sprintf "%s\nlet () = Format.printf \"\\x1f@.\";;\n"
    (String.sub text skip (String.length text - skip))

let run raylab scene phrases =
  let input = Filename.temp_file "transcript" ".ml" in
  Out_channel.with_open_bin input (fun channel ->
      List.iter
        (fun phrase -> output_string channel (input_of_phrase phrase))
        phrases);
  let command =
    Filename.quote_command raylab ~stdin:input [ "repl"; scene ] ^ " 2>&1"
  in
  let channel = Unix.open_process_in command in
  let output = In_channel.input_all channel in
  ignore (Unix.close_process_in channel : Unix.process_status);
  Sys.remove input;
  String.split_on_char mark output |> List.map String.trim

(* {1 Writing it again} *)

let rec print items answers =
  match (items, answers) with
  | Text line :: items, _ ->
      print_endline line;
      print items answers
  | Phrase lines :: items, answer :: answers ->
      List.iter print_endline lines;
      if answer <> "" then print_endline answer;
      print items answers
  | Phrase lines :: _, [] ->
      failwith ("no answer to " ^ String.concat "\n" lines)
  | [], _ -> ()

let () =
  match Sys.argv with
  | [| _; raylab; scene; page |] ->
      let items =
        read_text (In_channel.with_open_bin page In_channel.input_lines)
      in
      let phrase = function Phrase lines -> Some lines | Text _ -> None in
      print items (run raylab scene (List.filter_map phrase items))
  | _ -> failwith "usage: transcript RAYLAB SCENE PAGE"
