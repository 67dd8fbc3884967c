type place = Line of int | Byte of int | Whole
type t = { place : place; message : string }

let to_string { place; message } =
  match place with
  | Line n -> Printf.sprintf "line %d: %s" n message
  | Byte n -> Printf.sprintf "byte %d: %s" n message
  | Whole -> message

exception Found of t

let fail place format =
  Printf.ksprintf (fun message -> raise (Found { place; message })) format
