open Raylab_geometry
open Raylab_source

type t = { text : string; about : Origin.t list }

let in_main_file { Place.file; _ } = file = None

let to_string place { text; about } =
  match List.filter_map place about with
  | [] -> text
  | [ place ] -> Printf.sprintf "%s (%s)" text (Place.to_string place)
  | places when List.for_all in_main_file places ->
      let lines = List.map (fun p -> string_of_int p.Place.line) places in
      Printf.sprintf "%s (lines %s)" text (String.concat " and " lines)
  | places ->
      let places = List.map Place.to_string places in
      Printf.sprintf "%s (%s)" text (String.concat " and " places)

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
