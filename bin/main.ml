open Cmdliner

let commands render =
  [
    render;
    Cmd_view.cmd;
    Cmd_explain.cmd;
    Cmd_check.cmd;
    Cmd_repl.cmd;
    Cmd_join.cmd;
    Cmd_slurm.cmd;
    Cmd_help.cmd;
  ]

let man =
  [
    `S Manpage.s_description;
    `P
      "$(mname) renders a scene, described by a short text file, by ray \
       tracing.";
    `P
      "$(mname) $(i,SCENE), without the name of a command, renders \
       $(i,SCENE), saves the picture beside it, under its name with \
       $(b,.bmp), and shows it in a window if there is a display.";
  ]
  @ Guide.blocks

let program render =
  Cmd.group ~default:Cmd_render.default
    (Command.info "raylab" ~version:Version.number
       ~doc:"a ray tracer that can explain itself" man)
    (commands render)

(* Cmdliner takes a first argument without dash for the name of a command. It is
   a scene if it looks like a file or is one. *)
let is_scene argument =
  ((not (String.starts_with ~prefix:"-" argument)) || argument = "-")
  && (not
        (List.exists
           (fun c -> Cmd.name c = argument)
           (commands Cmd_render.cmd)))
  && (Sys.file_exists argument
     || String.exists (fun c -> c = '.' || c = '/' || c = '-') argument)

let program, argv =
  match Cmd_help.with_long_options (Array.to_list Sys.argv) with
  | name :: first :: rest when is_scene first ->
      let render = Cmd_render.default_cmd in
      (program render, Array.of_list (name :: Cmd.name render :: first :: rest))
  | arguments -> (program Cmd_render.cmd, Array.of_list arguments)

(* What is opened first would take the place of a standard stream that is
   closed: a window would get what is printed. Here one cannot be written to,
   or read, as before. *)
let hold_places () =
  let hold (descriptor, flag) =
    try ignore (Unix.fstat descriptor : Unix.stats)
    with Unix.Unix_error _ ->
      ignore (Unix.openfile "/dev/null" [ flag ] 0 : Unix.file_descr)
  in
  List.iter hold
    [
      (Unix.stdin, Unix.O_WRONLY);
      (Unix.stdout, O_RDONLY);
      (Unix.stderr, O_RDONLY);
    ]

(* Manuals are printed by Cmdliner, which leaves to others what goes wrong
   then. *)
let evaluate () =
  try
    let code =
      Cmd.eval' ~catch:false ~err:Command.usage_errors ~argv program
    in
    Format.print_flush ();
    code
  with Sys_error reason ->
    close_out_noerr stdout;
    Command.say "standard output: %s" reason;
    Exit_code.not_written

let () =
  hold_places ();
  (* a file that may not grow is an error of writing: see ulimit -f *)
  Sys.set_signal Sys.sigxfsz Signal_ignore;
  exit
    (Signals.cleaning Output.remove_temporary_files (fun () ->
         Signals.for_readers evaluate))
