(* Every scene that is named on the command line gives the same bytes on any
   number of domains, in another order of pixels, on every run, and while the
   machine is busy. *)

open Raylab_scene
open Raylab_language
open Raylab_tracer

(* Several tiles, and sides that are no multiple of one. *)
let width = 83
let height = 61

let bytes ~domains scene =
  (* the hierarchy is built on as many domains *)
  let picture, _ = Render.picture ~domains (Prepared.make ~domains scene) in
  Digest.bytes (Picture.to_rgb picture)

(* As in the window, every 8th pixel first. *)
let refined_bytes ~domains scene =
  let prepared = Prepared.make ~domains scene in
  let picture = Render.blank prepared in
  ignore
    (Render.refine ~domains ~on_tile:(fun _ _ -> ()) picture prepared
      : Tally.t);
  Digest.bytes (Picture.to_rgb picture)

(* [beside_load f] is [f ()] while other domains compute and allocate. *)
let beside_load f =
  let stop = Atomic.make false in
  let burn () =
    while not (Atomic.get stop) do
      ignore (Sys.opaque_identity (List.init 100 float_of_int))
    done
  in
  let load = List.init 3 (fun _ -> Domain.spawn burn) in
  Fun.protect f ~finally:(fun () ->
      Atomic.set stop true;
      List.iter Domain.join load)

let is_same path =
  match Scene_file.load ~access:Test_files.Nearby.access path with
  | Error _ ->
      Printf.eprintf "%s is in error\n" path;
      false
  | Ok scene ->
      let camera = Camera.with_size ~width ~height scene.camera in
      let scene = Scene.with_camera camera scene in
      let one = bytes ~domains:1 scene in
      let others =
        List.map (fun domains -> bytes ~domains scene) [ 1; 2; 3; 8 ]
      and refined = refined_bytes ~domains:2 scene
      and busy = beside_load (fun () -> bytes ~domains:3 scene) in
      let same = List.for_all (String.equal one) (refined :: busy :: others) in
      if not same then Printf.eprintf "%s: not always the same\n" path;
      same

let () =
  let paths = List.tl (Array.to_list Sys.argv) in
  let same = List.filter is_same paths in
  Printf.printf "%d of %d pictures are always the same\n" (List.length same)
    (List.length paths);
  if List.length same < List.length paths || paths = [] then exit 1
