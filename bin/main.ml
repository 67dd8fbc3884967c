open Cmdliner

let commands = [ Cmd_render.cmd; Cmd_check.cmd ]

let man =
  [
    `S Manpage.s_description;
    `P
      "$(mname) renders a scene, described by a short text file, by ray \
       tracing.";
    `P
      "$(mname) $(i,SCENE), without the name of a command, renders $(i,SCENE) \
       and saves the picture beside it, under its name with $(b,.bmp).";
  ]

let program =
  Cmd.group ~default:Cmd_render.default
    (Cmd.info "raylab" ~version:"%%VERSION%%"
       ~doc:"a ray tracer that can explain itself" ~man ~exits:Exit_code.infos)
    commands

(* Cmdliner takes a first argument without dash for the name of a command. It is
   a scene if it looks like a file or is one. *)
let is_scene argument =
  ((not (String.starts_with ~prefix:"-" argument)) || argument = "-")
  && (not (List.exists (fun c -> Cmd.name c = argument) commands))
  && (Sys.file_exists argument
     || String.exists (fun c -> c = '.' || c = '/' || c = '-') argument)

let argv =
  match Array.to_list Sys.argv with
  | program :: first :: rest when is_scene first ->
      (* as an argument after an option end, it names no command *)
      Array.of_list ((program :: rest) @ [ "--"; first ])
  | _ -> Sys.argv

let () = exit (Cmd.eval' ~argv program)
