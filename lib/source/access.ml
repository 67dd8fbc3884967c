type found = { path : string; identity : string }
type refusal = { message : string; advice : string }

type t = {
  main : string option;
  find : from:string -> string -> (found, refusal) result;
  read : limit:int -> found -> (string, refusal) result;
}

let refuse ?(advice = "") message = Error { message; advice }

let below folder path =
  let prefix = if folder = "/" then folder else folder ^ "/" in
  if String.starts_with ~prefix path then
    let n = String.length prefix in
    Some (String.sub path n (String.length path - n))
  else None

let join ~from name =
  let folder = Filename.dirname from in
  if from = "-" || folder = Filename.current_dir_name then name
  else if Filename.is_relative name then Filename.concat folder name
  else name

let none =
  let nothing () = refuse "no other file can be read here" in
  {
    main = None;
    find = (fun ~from:_ _ -> nothing ());
    read = (fun ~limit:_ _ -> nothing ());
  }
