open Cmdliner
open Raylab_language

exception Ended of int

let say message = Format.eprintf "raylab: %s@." message

let usage_error format =
  Printf.ksprintf
    (fun message ->
      say message;
      raise (Ended Exit_code.usage))
    format

let write_error message =
  say message;
  raise (Ended Exit_code.not_written)

let scene_arg =
  let doc = "The scene file, or $(b,-) for standard input." in
  Arg.(required & pos 0 (some string) None & info [] ~docv:"SCENE" ~doc)

let print_error error = Format.eprintf "%a@." Scene_error.pp error

let load_scene path =
  match Scene_file.load path with
  | Ok scene -> scene
  | Error errors ->
      List.iter print_error errors;
      raise (Ended Exit_code.scene_error)

let run action =
  let run action =
    match action () with () -> Exit_code.ok | exception Ended code -> code
  in
  Term.(const run $ action)

let info name ~doc man = Cmd.info name ~doc ~man ~exits:Exit_code.infos
