type piece =
  | Plain of string
  | Code of string
  | Strong of string
  | Picture of { shows : string; file : string }

type t = piece list

exception Unknown of string

let unknown format = Printf.ksprintf (fun what -> raise (Unknown what)) format
let from k text = String.sub text k (String.length text - k)

(* [until stop text i] is what of [text] is between [i] and the next [stop],
   and where that ends. *)
let until stop text i =
  let rec find j =
    if j > String.length text then unknown "a %s is missing" stop
    else if String.starts_with ~prefix:stop (from j text) then j
    else find (j + 1)
  in
  let j = find i in
  (String.sub text i (j - i), j + String.length stop)

(* [target ~targets text i] is where a link goes whose [(target)] or [[name]] is
   at [i], and where that ends. *)
let target ~targets text i =
  if String.starts_with ~prefix:"(" (from i text) then until ")" text (i + 1)
  else if String.starts_with ~prefix:"[" (from i text) then
    let name, next = until "]" text (i + 1) in
    match List.assoc_opt name targets with
    | Some target -> (target, next)
    | None -> unknown "nothing says where [%s] goes" name
  else unknown "a link goes nowhere"

(* [piece ~targets text i] is the pieces that are not plain and start at [i],
   and where they end. *)
let rec special ~targets text i =
  let is prefix = String.starts_with ~prefix (from i text) in
  if is "`" then
    let code, next = until "`" text (i + 1) in
    Some ([ Code code ], next)
  else if is "**" then
    let strong, next = until "**" text (i + 2) in
    Some ([ Strong strong ], next)
  else if is "![" then
    let shows, next = until "]" text (i + 2) in
    let file, next = target ~targets text next in
    Some ([ Picture { shows; file } ], next)
  else if is "[" then
    let link, next = until "]" text (i + 1) in
    let _, next = target ~targets text next in
    Some (parse ~targets link, next)
  else if is "*" || is "\\" || is "<" then
    unknown "%c stands for itself only in backquotes" text.[i]
  else None

and parse ~targets text =
  let rec go start i =
    let plain rest =
      if start = i then rest
      else Plain (String.sub text start (i - start)) :: rest
    in
    if i = String.length text then plain []
    else
      match special ~targets text i with
      | Some (pieces, next) -> plain (pieces @ go next next)
      | None -> go start (i + 1)
  in
  go 0 0
