open Raylab_source
open Raylab_scene
open Raylab_language
open Raylab_picture
open Raylab_window

(* a message may have several lines *)
let tell text = List.iter (Command.line "%s") (String.split_on_char '\n' text)
let terminal channel = Terminal.make channel ~tell

let check_size (scene : Scene.t) =
  let { Camera.width; height; _ } = scene.camera in
  Picture_file.check_size Bmp ~width ~height

let load ~allow path ?watch ?(on_read = ignore) ~adjust () =
  let access = Raylab_disk.Disk.access ~allow in
  let reading = Scene_file.read ~access path in
  let { Scene_file.sources; missing; scene; _ } = reading in
  let follow watch = Watch.follow watch (Sources.paths sources @ missing) in
  Option.iter follow watch;
  on_read reading;
  match scene with
  | Ok scene ->
      let scene = adjust scene in
      Result.map (fun () -> scene) (check_size scene)
  | Error errors ->
      let text = List.map (Format.asprintf "%a" Scene_error.pp) errors in
      Error (String.concat "\n" text)

let can_save path = Atomic_file.check ~path ~bytes:1
let ( let* ) = Result.bind

let save path picture =
  let* format = Picture_file.format_of_path path in
  let* outcome = Picture_file.save format ~path picture in
  Ok (Atomic_file.wrote ~path outcome)

let said = ( ^ ) "raylab: "

let source ?out path ~load =
  let out =
    match out with Some out -> Ok out | None -> Scene_path.picture path
  in
  let to_out f =
    Signals.cleaning Output.remove_temporary_files (fun () ->
        Result.map_error said (Result.bind out f))
  in
  let can_save () = to_out can_save
  and save picture =
    match to_out (fun path -> save path picture) with
    | Ok text -> said text
    | Error text -> text
  in
  let name = Filename.basename (Scene_path.name path) in
  { View.name; load; can_save; save }

let on_loss () = Unix._exit Exit_code.ok

let show ?domains ?rows ?watch ~output source first =
  Signals.at_once (fun () ->
      View.run ~on_loss ?domains ?rows ?watch ~terminal:(terminal output)
        source first)
