open Raylab_geometry

let at lines text =
  match List.map string_of_int (List.filter_map Fun.id lines) with
  | [] -> text
  | [ line ] -> Printf.sprintf "%s (line %s)" text line
  | lines -> Printf.sprintf "%s (lines %s)" text (String.concat " and " lines)

let most = 10

let few noun tell items =
  let told = List.filteri (fun k _ -> k < most) items in
  List.map tell told
  @
  match List.length items - most with
  | rest when rest <= 0 -> []
  | 1 -> [ Printf.sprintf "1 more %s is like that" noun ]
  | rest -> [ Printf.sprintf "%d more %ss are like that" rest noun ]

let name number (o : Object.t) =
  Printf.sprintf "%s %d" (Shape.name o.shape) number
