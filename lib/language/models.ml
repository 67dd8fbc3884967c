open Raylab_source
open Raylab_scene
open Raylab_mesh_file

type t = {
  known : (string, (Model.t * string, Access.refusal) result) Hashtbl.t;
  mutable meshes : Raylab_geometry.Mesh.t list; (* the last one first *)
  mutable triangles : int; (* of all of them *)
  mutable warnings : Warning.t list; (* the last one first *)
}

let start () =
  { known = Hashtbl.create 7; meshes = []; triangles = 0; warnings = [] }

let warn models offset name (fault : Fault.t) =
  let text =
    Printf.sprintf "%s, %s" (Printable.text name) (Fault.to_string fault)
  in
  let warning = { Warning.text; about = [ Literal offset ] } in
  models.warnings <- warning :: models.warnings

let of_bytes models offset name format bytes =
  let most = Mesh_file.most_triangles - models.triangles in
  match Mesh_file.read ~most format bytes with
  | Error fault -> Access.refuse (Fault.to_string fault)
  | Ok (facets, faults) ->
      models.triangles <-
        models.triangles + Raylab_geometry.Facets.count facets;
      List.iter (warn models offset name) faults;
      let model = Model.make ~name facets in
      models.meshes <- Model.mesh model ~is_smooth:false :: models.meshes;
      Ok model

let no_format () =
  Access.refuse "its name does not say which format it has"
    ~advice:"the name of a file of a mesh ends in .obj, .ply or .stl"

let read models ~at ~name bytes { Access.path; _ } =
  match Mesh_file.format_of_name name with
  | None -> no_format ()
  | Some format ->
      Result.bind (bytes ()) (of_bytes models at name format)
      |> Result.map (fun model -> (model, path))

let find models ~at ~name bytes (found : Access.found) =
  match Hashtbl.find_opt models.known found.identity with
  | Some known -> known
  | None ->
      let model = read models ~at ~name bytes found in
      Hashtbl.add models.known found.identity model;
      model

let meshes models = List.rev models.meshes
let warnings models = List.rev models.warnings
