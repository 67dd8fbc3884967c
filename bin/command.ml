open Cmdliner
open Raylab_language

exception Ended of int

(* Standard error may be closed or full. There is nobody to tell then, and the
   work itself goes on. *)
let print_line line =
  try
    prerr_string (line ^ "\n");
    flush stderr
  with Sys_error _ -> close_out_noerr stderr

let tell format = Printf.ksprintf print_line format

let say format =
  Printf.ksprintf (fun text -> print_line ("raylab: " ^ text)) format

let end_with code format =
  Printf.ksprintf
    (fun message ->
      say "%s" message;
      raise (Ended code))
    format

let usage_error format = end_with Exit_code.usage format
let write_error message = end_with Exit_code.not_written "%s" message

let scene_arg =
  let doc = "The scene file, or $(b,-) for standard input." in
  Arg.(required & pos 0 (some string) None & info [] ~docv:"SCENE" ~doc)

let print_error error = print_line (Format.asprintf "%a" Scene_error.pp error)

let load_scene path =
  match Scene_file.load path with
  | Ok scene -> scene
  | Error errors ->
      List.iter print_error errors;
      raise (Ended Exit_code.scene_error)

let is_same_file a b =
  match (Unix.stat a, Unix.stat b) with
  | a, b -> a.st_dev = b.st_dev && a.st_ino = b.st_ino
  | exception Unix.Unix_error _ -> false

let run action =
  let run action =
    match action () with () -> Exit_code.ok | exception Ended code -> code
  in
  Term.(const run $ action)

let info name ~doc man = Cmd.info name ~doc ~man ~exits:Exit_code.infos
