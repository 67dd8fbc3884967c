open Raylab_geometry

let sentence ((k, (first : Object.t)), (l, (second : Object.t))) =
  let text =
    Printf.sprintf "%s is where %s is: they hide each other"
      (Warning.name l second) (Warning.name k first)
  in
  { Warning.text; about = [ first.origin; second.origin ] }

let warnings objects =
  let seen = Hashtbl.create (List.length objects) in
  let twin_of k (o : Object.t) =
    let place = Shape.place o.shape and here = (k + 1, o) in
    match Hashtbl.find_opt seen place with
    | Some first -> Some (first, here)
    | None ->
        Hashtbl.add seen place here;
        None
  in
  List.mapi twin_of objects |> List.filter_map Fun.id
  |> Warning.few "object" sentence
