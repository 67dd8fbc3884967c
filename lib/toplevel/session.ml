open Raylab_scene
open Raylab_language
open Raylab_tracer
open Raylab_picture

type t = {
  scene : Scene.t;
  file : string option;
  trace : Prepared.t Lazy.t;
  walk : Walk.t option;
}

let about ?file scene =
  { scene; file; trace = lazy (Prepared.make scene); walk = None }

let current = ref (about Build.empty)
let scene () = !current.scene
let file () = !current.file
let trace () = Lazy.force !current.trace
let use scene = current := about scene
let folders = ref []
let allow paths = folders := paths
let allowed () = !folders

let read path =
  Scene_file.load ~access:(Raylab_disk.Disk.access ~allow:!folders) path

let load path =
  let loaded = read path in
  let file = if Target.has_name path then Some path else None in
  Result.iter (fun scene -> current := about ?file scene) loaded;
  loaded

let walk () = !current.walk
let set_walk place = current := { !current with walk = Some place }
