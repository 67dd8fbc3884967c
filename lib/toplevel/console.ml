open Raylab_source
open Raylab_scene
open Raylab_language
open Raylab_explanation

let errors = List.iter (Format.eprintf "%a@." Scene_error.pp)

let warnings ?path texts =
  let file =
    Option.fold ~none:"" ~some:(fun path -> Printable.text path ^ ": ") path
  in
  List.iter (Format.eprintf "%swarning: %s@." file) texts

let count list noun =
  let n = List.length list in
  Printf.sprintf "%d %s%s" n noun (if n = 1 then "" else "s")

let contents path (scene : Scene.t) =
  Format.printf "%s: %s, %s, %d x %d pixels@." (Printable.text path)
    (count scene.objects "object")
    (count scene.lights "light")
    scene.camera.width scene.camera.height

let swatches () =
  Swatch.detect ~is_terminal:(Unix.isatty Unix.stdout) Sys.getenv_opt

let summary pixel =
  Format.printf "%a@."
    (Report.pp_pixel_summary_with ~swatches:(swatches ()))
    pixel
