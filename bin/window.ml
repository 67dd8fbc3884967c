open Raylab_scene
open Raylab_language
open Raylab_picture
open Raylab_window

(* a message may have several lines *)
let tell text = List.iter (Command.tell "%s") (String.split_on_char '\n' text)
let terminal channel = Terminal.make channel ~tell

let check_size (scene : Scene.t) =
  let { Camera.width; height; _ } = scene.camera in
  Picture_file.check_size Bmp ~width ~height

let load path ~adjust () =
  match Scene_file.load path with
  | Ok scene ->
      let scene = adjust scene in
      Result.map (fun () -> scene) (check_size scene)
  | Error errors ->
      let text = List.map (Format.asprintf "%a" Scene_error.pp) errors in
      Error (String.concat "\n" text)

let save path picture =
  let written =
    Result.bind (Picture_file.format_of_path path) (fun format ->
        Picture_file.save format ~path picture)
  in
  match written with
  | Ok () -> "raylab: wrote " ^ path
  | Error message -> "raylab: " ^ message

let source ?out path ~load =
  let save =
    match out with
    | Some out -> save out
    | None when path = "-" ->
        fun _ ->
          "raylab: a scene from standard input has no name to call its \
           picture after: say where it goes with -o"
    | None -> save (Output.beside path)
  in
  let name = if path = "-" then "standard input" else Filename.basename path in
  let save picture =
    Signals.cleaning Output.remove_temporary_files (fun () -> save picture)
  in
  { Session.name; load; save }

let on_loss () = Unix._exit Exit_code.ok

let show ?domains ?rows ?watch ~output source first =
  Signals.at_once (fun () ->
      View.run ~on_loss ?domains ?rows ?watch ~terminal:(terminal output)
        source first)
