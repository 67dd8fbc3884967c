type format = Obj | Ply | Stl

let formats = [ ("obj", Obj); ("ply", Ply); ("stl", Stl) ]

let format_of_name name =
  let has (extension, _) =
    String.ends_with ~suffix:("." ^ extension) (String.lowercase_ascii name)
  in
  Option.map snd (List.find_opt has formats)

let reader = function Obj -> Obj.read | Ply -> Ply.read | Stl -> Stl.read
let most_triangles = 20_000_000

let read ?(most = most_triangles) format bytes =
  match Builder.finish (reader format ~most bytes) with
  | mesh -> Ok mesh
  | exception Fault.Found fault -> Error fault
