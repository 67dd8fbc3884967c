open Raylab_geometry

type t = { text : string; about : Origin.t list }

let is_line { Provenance.place; steps } = place.file = None && steps = []

let to_string provenance { text; about } =
  match List.filter_map provenance about with
  | [] -> text
  | [ one ] -> Printf.sprintf "%s (%s)" text (Provenance.to_string one)
  | lines when List.for_all is_line lines ->
      let line { Provenance.place; _ } = string_of_int place.line in
      Printf.sprintf "%s (lines %s)" text
        (String.concat " and " (List.map line lines))
  | several ->
      Printf.sprintf "%s (%s)" text
        (String.concat " and " (List.map Provenance.to_string several))

let most = 10

let few noun sentence items =
  let told = List.filteri (fun k _ -> k < most) items in
  List.map sentence told
  @
  match List.length items - most with
  | rest when rest <= 0 -> []
  | rest ->
      let text =
        if rest = 1 then Printf.sprintf "1 more %s is like that" noun
        else Printf.sprintf "%d more %ss are like that" rest noun
      in
      [ { text; about = [] } ]

let name number (o : Object.t) =
  Printf.sprintf "%s %d" (Shape.name o.shape) number
