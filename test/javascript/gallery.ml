(* Of every scene that is named on the command line: a digest of its picture,
   made small, and of the explanations of some of its pixels. *)

open Raylab_scene
open Raylab_language
open Raylab_tracer
open Raylab_explanation

let width = 60

let small scene =
  let camera = scene.Scene.camera in
  let shape = float_of_int camera.height /. float_of_int camera.width in
  let height = Int.max 1 (Float.to_int (Float.round (float width *. shape))) in
  Scene.with_camera (Camera.with_size ~width ~height camera) scene

(* Every [step]th of every [step]th row. *)
let step = 7

let explained scene picture =
  let along length = List.init ((length + step - 1) / step) (( * ) step) in
  List.concat_map
    (fun y ->
      List.map
        (fun x -> Explain.pixel scene ~x ~y)
        (along (Picture.width picture)))
    (along (Picture.height picture))

let tell path =
  match Scene_file.load ~access:Test_files.Nearby.access path with
  | Error _ -> Printf.printf "%s is in error\n" path
  | Ok scene ->
      let scene = Prepared.make (small scene) in
      let picture, _ = Render.picture ~domains:1 scene in
      let explanations = Json.document (explained scene picture) in
      let hex text = Digest.to_hex (Digest.string text) in
      Printf.printf "%s: picture %s, explanations %s\n" path
        (hex (Bytes.to_string (Picture.to_rgb picture)))
        (hex (Json.to_string explanations))

let () = List.iter tell (List.tl (Array.to_list Sys.argv))
