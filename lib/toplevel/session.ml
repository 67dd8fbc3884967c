open Raylab_scene
open Raylab_language
open Raylab_tracer

type t = { scene : Scene.t; trace : Trace.t Lazy.t; walk : Walk.t option }

let about scene = { scene; trace = lazy (Trace.prepare scene); walk = None }
let current = ref (about Build.empty)
let scene () = !current.scene
let trace () = Lazy.force !current.trace
let use scene = current := about scene

let load path =
  let loaded = Scene_file.load path in
  Result.iter use loaded;
  loaded

let walk () = !current.walk
let set_walk place = current := { !current with walk = Some place }
