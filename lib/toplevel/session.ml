open Raylab_scene
open Raylab_language
open Raylab_tracer
open Raylab_picture

type t = {
  scene : Scene.t;
  file : string option;
  time : float;
  trace : Prepared.t Lazy.t;
  walk : Walk.t option;
}

let about ?file ?(time = 0.) scene =
  { scene; file; time; trace = lazy (Prepared.make scene); walk = None }

let current = ref (about Build.empty)
let scene () = !current.scene
let file () = !current.file
let time () = !current.time
let trace () = Lazy.force !current.trace
let use scene = current := about scene
let folders = ref []
let allow paths = folders := paths
let allowed () = !folders

let read ?time path =
  let access = Raylab_disk.Disk.access ~allow:!folders in
  Scene_file.read ?time ~access path

let load ?time path =
  let reading = read ?time path in
  let file = if Target.has_name path then Some path else None in
  Result.iter (fun scene -> current := about ?file ?time scene) reading.scene;
  reading

let walk () = !current.walk
let set_walk place = current := { !current with walk = Some place }
