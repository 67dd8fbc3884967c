open Raylab_geometry
open Raylab_mesh_file

let model (name, text) =
  match Mesh_file.read Obj text with
  | Ok (facets, _) -> Model.make ~name facets
  | Error fault -> failwith (Fault.to_string fault)

let models = List.map model Test_files.Mesh_texts.all

let all =
  List.concat_map
    (fun model ->
      List.map (fun is_smooth -> Model.mesh model ~is_smooth) [ false; true ])
    models

let solid = List.filter Mesh.is_closed all
let access = Test_files.Mesh_texts.access
