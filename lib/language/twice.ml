open Raylab_source

type t = { findings : Findings.t; names : (string, Span.t) Hashtbl.t }

let start check = { findings = Check.findings check; names = Hashtbl.create 7 }

let tell { findings; _ } name span first =
  let { Sources.line; _ } = Sources.place (Findings.sources findings) first in
  Findings.error findings span
    (Printf.sprintf "%s is defined a second time" name)
    ~advice:
      (Printf.sprintf "it is already defined in line %d; choose another name"
         line)

let item t (item : Syntax.item) =
  match item with
  | Definition { name; name_span; _ } -> (
      let key = String.lowercase_ascii name in
      match Hashtbl.find_opt t.names key with
      | None -> Hashtbl.add t.names key name_span
      | Some first -> tell t name name_span first)
  | _ -> ()
