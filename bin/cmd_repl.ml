open Cmdliner
open Raylab_toplevel
open Raylab_picture

(* utop needs bytecode, and raylab is native code. *)
let prompt = "raylab-utop"

let repl scene script allow () =
  let scene, script =
    match (scene, script) with
    | Some script, None when Filename.check_suffix script ".ml" ->
        (None, Some script)
    | arguments -> arguments
  in
  if
    Option.fold ~none:false ~some:Target.is_standard_input scene
    && script = None
  then
    Command.usage_error
      "a scene from standard input leaves nothing for the prompt to read";
  let here = Sys.executable_name in
  let program = Filename.concat (Filename.dirname here) prompt in
  let argument = Option.value ~default:"" in
  Unix.putenv Native.variable here;
  try
    Unix.execv program
      (Array.of_list (program :: argument scene :: argument script :: allow))
  with Unix.Unix_error (error, _, _) ->
    Command.say "cannot run %s, which belongs beside %s: %s%s" program here
      (Unix.error_message error)
      (if error = ENOENT then ". In a checkout dune build @install makes it"
       else "");
    raise (Command.Ended Cmd.Exit.internal_error)

let scene =
  let doc = "The scene file. Without it the scene is empty." in
  Arg.(value & pos 0 (some string) None & info [] ~docv:"SCENE" ~doc)

let script =
  let doc =
    "A file of OCaml to run instead of asking for input. If its name ends in \
     $(b,.ml), SCENE may be left out."
  in
  Arg.(value & pos 1 (some string) None & info [] ~docv:"SCRIPT" ~doc)

let exits =
  [
    Cmd.Exit.info 0 ~doc:"when you leave, and if $(i,SCRIPT) came to its end.";
    Cmd.Exit.info 1
      ~doc:
        "if there is a $(i,SCRIPT) and $(i,SCENE) is in error: it is not run.";
    Cmd.Exit.info 2
      ~doc:
        "if $(i,SCRIPT) cannot be read, is wrong, or ended with an exception, \
         such as of an assertion that failed. A call of $(b,exit) in it is \
         obeyed.";
    Cmd.Exit.info Exit_code.usage ~doc:"if the command line is wrong.";
    Cmd.Exit.info Cmd.Exit.internal_error
      ~doc:"if raylab is not installed as a whole.";
  ]

let cmd =
  let man =
    [
      `S Manpage.s_description;
      `P
        "Starts utop, OCaml's prompt, with the library of raylab open and \
         $(i,SCENE) loaded. $(b,help ()) lists what can be said there, such \
         as $(b,pixel 320 240): why has this pixel its colour?";
      `P
        "If $(i,SCENE) is in error that is reported, and the prompt comes up \
         with an empty scene. Without a terminal, what comes from standard \
         input is evaluated, and the values are printed. On a terminal that \
         obeys no escape codes, with $(b,TERM) missing or $(b,dumb), the \
         prompt is a plain one, without editing, completion and history.";
      `P
        "Pictures are rendered as fast as by $(b,raylab render), for it is \
         what renders them.";
      `S Manpage.s_files;
      `P
        "$(b,~/.local/state/raylab/history) keeps what was typed; \
         $(b,XDG_STATE_HOME) may put it elsewhere.";
      `P
        "utop's own files of settings, such as $(b,~/.config/utop/init.ml), \
         are read at a terminal.";
    ]
  in
  Cmd.v
    (Command.info "repl" ~doc:"explore a scene at OCaml's prompt" ~exits man)
    (Command.run Term.(const repl $ scene $ script $ Options.allow))
