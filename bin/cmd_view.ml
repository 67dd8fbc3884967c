open Cmdliner
open Raylab_picture
open Raylab_window

type options = {
  scene : string;
  allow : string list;
  view : Options.view;
  out : string option;
  domains : int option;
  watch : bool;
  from_prompt : bool;
}

let load ?watch ?on_read options =
  Window.load ~allow:options.allow options.scene ?watch ?on_read
    ~adjust:(Options.adjust options.view)

(* The prompt has told of its scene what there is to tell. *)
let read options =
  if options.from_prompt then (None, Command.handed_over options.scene)
  else
    let reading, scene =
      Command.read_scene ~allow:options.allow options.scene
    in
    (Some reading, scene)

let on_read options reading =
  Option.iter (fun path -> Output.protect path reading) options.out;
  Warnings.tell_as options.view options.scene reading

let first ?watch options =
  if options.watch then
    match load ?watch ~on_read:(on_read options) options () with
    | Ok scene -> View.Scene scene
    | Error message -> Error message
  else
    let reading, written = read options in
    let scene = Options.adjust options.view written in
    match Window.check_size scene with
    | Ok () ->
        Option.iter (on_read options) reading;
        Scene scene
    | Error message -> Command.write_error message

let view options () =
  let path = options.scene in
  if options.watch && Scene_path.is_stream path then
    Command.usage_error "option --watch: %s cannot be watched"
      (Scene_path.name path);
  let check_out out =
    if Target.is_standard_output out then
      Command.usage_error "option -o: explanations go to standard output";
    ignore
      (Output.format out ~inputs:[ path ] ~named:"the scene"
        : Picture_file.format);
    Result.iter_error Command.write_error (Window.can_save out)
  in
  Option.iter check_out options.out;
  (* before the scene is read, so that no change is missed *)
  let watch = if options.watch then Some (Watch.start path) else None in
  let first = first ?watch options in
  let load () =
    match first with
    | Scene scene when Scene_path.is_stream path || options.from_prompt ->
        Ok scene
    | _ -> load ?watch options ()
  in
  match
    Window.show ?domains:options.domains ?watch ~output:stdout
      (Window.source ?out:options.out path ~load)
      first
  with
  | Ok () -> ()
  | Error message -> Command.write_error message

let options =
  let out =
    let doc =
      "Where the key s saves the picture; the extension of $(docv) says in \
       which format, as for $(b,raylab render). By default it goes beside the \
       scene, under its name with $(b,.bmp)."
    in
    Arg.(
      value & opt (some string) None & info [ "o"; "output" ] ~docv:"OUT" ~doc)
  and watch =
    let doc =
      "Render again whenever the scene file changes. If it is in error, the \
       window says so and waits for the next change."
    in
    Arg.(value & flag & info [ "w"; "watch" ] ~doc)
  in
  let make scene allow view out domains watch from_prompt =
    { scene; allow; view; out; domains; watch; from_prompt }
  in
  Term.(
    const make $ Command.scene_arg $ Options.allow $ Options.view $ out
    $ Options.domains $ watch $ Options.from_prompt)

let cmd =
  let man =
    [
      `S Manpage.s_description;
      `P
        "Opens a window that shows the picture of $(i,SCENE) while it is \
         rendered, coarse at first. A picture that is larger than the screen \
         is scaled down.";
      `P
        "A click explains a pixel, on standard output as $(b,raylab explain) \
         does, and draws the path of its rays over the picture. These keys do \
         something while the window has the focus:";
      `Pre Raylab_viewer.Key.help;
      `P "Without a display it says so, and the exit status is 2.";
    ]
  in
  Cmd.v
    (Command.info "view" ~doc:"show a scene in a window" man)
    (Command.run Term.(const view $ options))
