(* console PAGE DIR prints PAGE anew: after each line "$ COMMAND" of a console
   block comes what COMMAND prints in DIR. *)

let command line =
  if String.starts_with ~prefix:"$ " line then
    Some (String.sub line 2 (String.length line - 2))
  else None

let run dir command =
  let channel =
    Unix.open_process_in
      (Printf.sprintf "cd %s && { %s; } 2>&1" (Filename.quote dir) command)
  in
  let output = In_channel.input_all channel in
  ignore (Unix.close_process_in channel : Unix.process_status);
  print_string output

let rec copy_text dir = function
  | line :: rest ->
      print_endline line;
      (if line = "```console" then copy_block else copy_text) dir rest
  | [] -> ()

and copy_block dir = function
  | "```" :: _ as lines -> copy_text dir lines
  | line :: rest ->
      Option.iter
        (fun command ->
          print_endline line;
          flush stdout;
          run dir command)
        (command line);
      copy_block dir rest
  | [] -> failwith "a block without end"

let () =
  match Sys.argv with
  | [| _; page; dir |] ->
      copy_text dir (In_channel.with_open_bin page In_channel.input_lines)
  | _ -> failwith "usage: console PAGE DIR"
