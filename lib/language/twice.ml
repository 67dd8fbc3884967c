open Raylab_source

type t = { findings : Findings.t; names : (string, Span.t) Hashtbl.t }

let start check = { findings = Check.findings check; names = Hashtbl.create 7 }

let place { findings; _ } { Span.start; _ } =
  match Files.place (Sources.table (Findings.sources findings)) start with
  | Some place -> Place.to_string place
  | None -> "another place"

let tell t name span first =
  Findings.error t.findings span
    (Printf.sprintf "%s is defined a second time" name)
    ~advice:
      (Printf.sprintf "it is already defined in %s; choose another name"
         (place t first))

let tell_included t name span ~again first =
  Findings.error t.findings span
    (Printf.sprintf "%s is defined a second time, in %s" name (place t again))
    ~advice:
      (Printf.sprintf
         "it is already defined in %s; what is included must not define the \
          same names"
         (place t first))

let note t name span ~tell =
  let key = String.lowercase_ascii name in
  match Hashtbl.find_opt t.names key with
  | None -> Hashtbl.add t.names key span
  | Some first when first = span -> ()
  | Some first -> tell first

let included t span { File_code.names; _ } =
  let note_name (name, { Raylab_expression.Scope.span = again; _ }) =
    note t name again ~tell:(tell_included t name span ~again)
  in
  List.iter note_name names

let item t (item : Syntax.item) =
  match item with
  | Definition { name; name_span; _ } ->
      note t name name_span ~tell:(tell t name name_span)
  | _ -> ()
