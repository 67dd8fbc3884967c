type t = { file : string option; line : int }

let to_string { file; line } =
  match file with
  | None -> Printf.sprintf "line %d" line
  | Some file -> Printf.sprintf "line %d of %s" line file
