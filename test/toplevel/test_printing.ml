(* Whatever is called pp serves Format's %a: options belong to a pp_with. *)

let interfaces () =
  let rec below directory =
    Sys.readdir directory |> Array.to_list |> List.sort compare
    |> List.concat_map (fun name ->
           let path = Filename.concat directory name in
           if Sys.is_directory path then below path
           else if Filename.check_suffix name ".mli" then [ path ]
           else [])
  in
  below "../../lib"

let read path = In_channel.with_open_bin path In_channel.input_all

(* [words text] is [text] without line ends, each word after one blank. *)
let words text =
  String.map (function '\n' -> ' ' | c -> c) text
  |> String.split_on_char ' '
  |> List.filter (( <> ) "")

(* The values of an interface whose names begin with pp, and their types. *)
let printers path =
  let rec find found = function
    | "val" :: name :: ":" :: rest when String.starts_with ~prefix:"pp" name ->
        let rec type_of = function
          | ("(**" | "val" | "end") :: _ | [] -> []
          | word :: rest -> word :: type_of rest
        in
        find ((path, name, String.concat " " (type_of rest)) :: found) rest
    | _ :: rest -> find found rest
    | [] -> List.rev found
  in
  find [] (words (read path))

let takes_one_value type_ =
  match String.split_on_char '>' type_ with
  | [ "Format.formatter -"; value; " unit" ] ->
      not (String.contains value ':' || String.contains value '?')
  | _ -> false

let test_types () =
  let printers = List.concat_map printers (interfaces ()) in
  Alcotest.(check bool) "some are found" true (List.length printers > 15);
  List.iter
    (fun (path, name, type_) ->
      if not (String.ends_with ~suffix:"_with" name) then
        Alcotest.(check bool)
          (Printf.sprintf "%s: %s : %s" path name type_)
          true (takes_one_value type_))
    printers

let suite = ("Printing", [ Alcotest.test_case "types" `Quick test_types ])
