open Cmdliner
open Raylab_scene
open Raylab_language

let check ~allow path =
  match Scene_file.load ~access:(Raylab_disk.Disk.access ~allow) path with
  | Ok scene ->
      List.iter
        (Command.line "%s: warning: %s" (Raylab_source.Printable.text path))
        (Scene.warnings scene);
      true
  | Error errors ->
      List.iter Command.print_error errors;
      false

let check_all allow paths () =
  (* every scene is read, also after one in error *)
  let right = List.map (check ~allow) paths in
  if not (List.for_all Fun.id right) then
    raise (Command.Ended Exit_code.scene_error)

let scenes =
  let doc = "The scene files, or $(b,-) for standard input." in
  Arg.(non_empty & pos_all string [] & info [] ~docv:"SCENE" ~doc)

let cmd =
  let man =
    [
      `S Manpage.s_description;
      `P
        "Reads each $(i,SCENE) and prints every error and warning to standard \
         error. Renders nothing. Warnings do not change the exit status.";
    ]
  in
  Cmd.v
    (Command.info "check" ~doc:"report the errors and warnings of scenes" man)
    (Command.run Term.(const check_all $ Options.allow $ scenes))
