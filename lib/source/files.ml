type file = { name : string; base : int; lines : Lines.t }
type t = file array

let none = [||]

(* a file's end is the last of its offsets *)
let last files =
  match Array.length files with
  | 0 -> -1
  | count ->
      let { base; lines; _ } = files.(count - 1) in
      base + Lines.length lines

let add ~name lines files =
  Array.append files [| { name; base = last files + 1; lines } |]

let is_in files offset = 0 <= offset && offset <= last files

type found = { index : int; name : string; line : Lines.line }

let find files offset =
  if not (is_in files offset) then
    invalid_arg (Printf.sprintf "offset %d is in no file" offset);
  let index = Search.last_from (fun (file : file) -> file.base) files offset in
  let { name; base; lines } = files.(index) in
  { index; name; line = Lines.at lines (offset - base) }

let place files offset =
  if is_in files offset then
    let { index; name; line; _ } = find files offset in
    let file = if index = 0 then None else Some name in
    Some { Place.file; line = line.number + 1 }
  else None
