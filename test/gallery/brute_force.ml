(* Every scene that is named on the command line gives the same picture, byte
   for byte, whether hits are found by fans, grid and hierarchy or by testing
   every shape. *)

open Raylab_geometry
open Raylab_scene
open Raylab_language
open Raylab_tracer

(* Small: brute force takes as long as there are objects. *)
let size = 64

let picture index scene =
  let camera = Camera.with_size ~width:size ~height:size scene.Scene.camera in
  Prepared.make ~index (Scene.with_camera camera scene)
  |> Prepared.for_many_rays ~rays:max_int
  |> Render.picture |> fst

let is_same path =
  match Scene_file.load ~access:Test_files.Nearby.access path with
  | Error _ ->
      Printf.eprintf "%s is in error\n" path;
      false
  | Ok scene ->
      let same =
        Picture.equal
          (picture (Index.hierarchy ~domains:1) scene)
          (picture Index.brute_force scene)
      in
      if not same then
        Printf.eprintf "%s: brute force gives another picture\n" path;
      same

let () =
  let paths = List.tl (Array.to_list Sys.argv) in
  let same = List.filter is_same paths in
  Printf.printf "%d of %d pictures are those of brute force\n"
    (List.length same) (List.length paths);
  if List.length same < List.length paths || paths = [] then exit 1
