open Raylab_scene
open Raylab_language
open Raylab_explanation
open Raylab_picture
open Raylab_window

(* Nobody may be reading. The window goes on. *)
let write channel text =
  try
    output_string channel text;
    flush channel
  with Sys_error _ -> close_out_noerr channel

(* a message may have several lines *)
let tell text = List.iter (Command.tell "%s") (String.split_on_char '\n' text)

let terminal channel =
  let swatches =
    let descriptor = Unix.descr_of_out_channel channel in
    Swatch.detect ~is_terminal:(Unix.isatty descriptor) Sys.getenv_opt
  in
  {
    Session.print = (fun text -> write channel (text ^ "\n"));
    tell;
    explain =
      (fun pixel e ->
        write channel (Format.asprintf "%a@.@." (Report.pp ~swatches ~pixel) e));
  }

let check_size (scene : Scene.t) =
  let { Camera.width; height; _ } = scene.camera in
  Result.map (fun () -> scene) (Picture_file.check_size Bmp ~width ~height)

let load path view () =
  match Scene_file.load path with
  | Ok scene -> check_size (Options.adjust view scene)
  | Error errors ->
      let text = List.map (Format.asprintf "%a" Scene_error.pp) errors in
      Error (String.concat "\n" text)

let save path picture =
  if path = "-" then
    "raylab: a scene from standard input has no name to call its picture after"
  else
    let path = Filename.remove_extension path ^ ".bmp" in
    match Picture_file.save Bmp ~path picture with
    | Ok () -> "raylab: wrote " ^ path
    | Error message -> "raylab: " ^ message

let source path ~load =
  {
    Session.name =
      (if path = "-" then "standard input" else Filename.basename path);
    load;
    save = save path;
  }

let on_loss () = Unix._exit Exit_code.ok
