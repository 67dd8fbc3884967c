open Raylab_source
open Raylab_expression

let place files offset =
  match Files.place files offset with
  | None -> ""
  | Some place -> Place.to_string place

let step files (trail : Trail.t) =
  match trail with
  | Start -> ""
  | Call { name; arguments; at; _ } ->
      let argument (label, value) =
        Printf.sprintf "%s: %s" label (Datum.to_string value)
      in
      Printf.sprintf "in %s(%s), called in %s" name
        (String.concat ", " (List.map argument arguments))
        (place files at)
  | Round { loop = { name; at }; value; _ } ->
      Printf.sprintf "with %s = %s, %s" name (Datum.to_string value)
        (place files at)

let most_inner = 5
let most_outer = 3

(* Of a deep recursion both ends tell something. *)
let tell files trail =
  let steps = Trail.apart trail ~from:Start in
  let count = List.length steps in
  let some keep = List.map (step files) (List.filteri keep steps) in
  if count <= most_inner + most_outer then some (fun _ _ -> true)
  else
    let between = count - most_inner - most_outer in
    some (fun k _ -> k < most_inner)
    @ [ Printf.sprintf "and %d more between these and" between ]
    @ some (fun k _ -> k >= count - most_outer)
