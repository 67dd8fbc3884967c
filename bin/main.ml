open Cmdliner

let commands = [ Cmd_render.cmd; Cmd_explain.cmd; Cmd_check.cmd; Cmd_repl.cmd ]

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
    (Cmd.info "raylab" ~version:Version.number
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
      Array.of_list (program :: Cmd.name Cmd_render.cmd :: first :: rest)
  | _ -> Sys.argv

(* Ends at once, whatever the other domains are at, and leaves no file behind. *)
let end_by_signal code _ =
  List.iter Sys.remove (Raylab_picture.Atomic_file.temporary ());
  Unix._exit code

let () =
  (* a reader that goes away is an error of writing, told as one *)
  Sys.set_signal Sys.sigpipe Signal_ignore;
  List.iter
    (fun (signal, code) ->
      Sys.set_signal signal (Signal_handle (end_by_signal code)))
    [
      (Sys.sigint, Exit_code.interrupted);
      (Sys.sighup, Exit_code.hung_up);
      (Sys.sigterm, Exit_code.terminated);
    ];
  exit (Cmd.eval' ~err:Command.usage_errors ~argv program)
