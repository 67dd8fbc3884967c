open Cmdliner
open Raylab_parallel
open Raylab_scene
open Raylab_source
open Raylab_language
open Raylab_tracer
open Raylab_picture
open Raylab_band

(* Whether a window opens afterwards. *)
type show = Never | If_there_is_a_display | Asked_for

type options = {
  scene : string;
  from_prompt : bool;
  allow : string list;
  view : Options.view;
  out : string option;
  format : Picture_file.format option;
  domains : int option;
  rows : Render.rows option;
  show : show;
  stats : bool;
  quiet : bool;
}

(* {1 Where the picture goes} *)

let path { scene; out; format; _ } =
  match (out, Scene_path.picture ?format scene) with
  | Some path, _ | None, Ok path -> path
  | None, Error message -> Command.usage_error "%s" message

let format options path =
  Output.format ?wanted:options.format path ~inputs:[ options.scene ]
    ~named:"the scene"

(* {1 Rendering} *)

let check_rows options { Camera.height; _ } =
  match options.rows with
  | Some { last; _ } when last >= height ->
      Command.usage_error
        "option --rows: the picture has no row %d; its rows are 0 to %d" last
        (height - 1)
  | _ -> ()

let check_picture format options target { Camera.width; height; _ } =
  let height =
    match options.rows with
    | Some { first; last } -> last - first + 1
    | None -> height
  in
  Destination.check format target ~width ~height

let band options reading { Scene.camera = { width; height; _ }; film; _ } =
  let of_rows { Render.first; last } =
    let sources { Scene_file.sources; _ } = sources in
    let scene =
      Sources.digest (Option.fold reading ~none:Sources.none ~some:sources)
    and grey = Options.is_grey options.view in
    Band.make
      { width; height; grey; film; scene; version = Version.number }
      ~first ~last
  in
  Option.map of_rows options.rows

let show options target scene picture ~seconds =
  let quietly = options.quiet && options.show <> Asked_for in
  let wanted =
    match (options.show, (target : Destination.t)) with
    | Never, _ | If_there_is_a_display, Standard_output -> false
    | If_there_is_a_display, File _ | Asked_for, _ -> true
  in
  let output =
    (* there the picture is *)
    match target with
    | Standard_output -> stderr
    | File _ -> stdout
  in
  if wanted then
    let load () =
      if Scene_path.is_stream options.scene || options.from_prompt then
        Ok scene.Prepared.scene
      else
        Window.load ~allow:options.allow options.scene
          ~adjust:(Options.adjust options.view)
          ()
    in
    match
      Window.show ?domains:options.domains ?rows:options.rows ~output
        (Window.source options.scene ~load)
        (Rendered { scene; picture; seconds })
    with
    | Ok () -> ()
    | Error message when not quietly ->
        Command.say "%s. The picture is not shown" message
    | Error _ -> ()

(* The prompt has told of its scene what there is to tell. *)
let read options path =
  if options.from_prompt then (None, Command.handed_over options.scene)
  else
    let reading, scene =
      Command.read_scene ~allow:options.allow options.scene
    in
    Output.protect path reading;
    (Some reading, scene)

let render options () =
  let path = path options in
  let target = Destination.of_path path in
  let format = format options path in
  let reading, written = read options path in
  let scene = Options.adjust options.view written in
  check_rows options scene.camera;
  check_picture format options target scene.camera;
  let band = band options reading scene in
  if not options.quiet then
    Option.iter (Warnings.tell_as options.view options.scene) reading;
  let progress = Progress.start ~quiet:options.quiet in
  let started = Unix.gettimeofday () in
  let domains =
    Option.value options.domains ~default:(Parallel.default_domains ())
  in
  let ready = Prepared.make ~domains scene in
  let picture, tally =
    Signals.cleaning
      (fun () -> Progress.leave progress)
      (fun () ->
        Render.picture ~domains ?rows:options.rows
          ~on_progress:(Progress.update progress) ready)
  in
  let seconds = Unix.gettimeofday () -. started in
  Progress.clear progress;
  Destination.write ~quiet:options.quiet format target band picture;
  if options.stats then Statistics.print tally picture ~seconds;
  show options target ready picture ~seconds

(* {1 The command line} *)

let rows =
  let parse text =
    match Options.pair '-' text with
    | Some (first, last) when first <= last -> Ok { Render.first; last }
    | _ ->
        Error
          (Printf.sprintf
             "'%s' is not a band of rows: expected the first and the last, \
              such as 0-99"
             text)
  in
  Options.conv parse ~docv:"A-B" (fun ppf { Render.first; last } ->
      Format.fprintf ppf "%d-%d" first last)

let asked_for =
  let doc =
    "Then show the picture in a window, as $(b,raylab view) does. Without a \
     display it is written all the same, and this is no failure."
  in
  let flag = Arg.(value & flag & info [ "show" ] ~doc) in
  Term.(const (fun asked -> if asked then Asked_for else Never) $ flag)

let options show =
  let open Arg in
  let out =
    let doc =
      "Write the picture to $(docv). Its extension says in which format: \
       $(b,.bmp), $(b,.png) or $(b,.ppm); without extension, and on standard \
       output, which is $(b,-), it is BMP, or what $(b,--format) says. By \
       default the picture goes beside the scene, under its name with the \
       extension of the format in the place of $(b,.scene) or $(b,.txt). A \
       picture that is already there is replaced."
    in
    value & opt (some string) None & info [ "o"; "output" ] ~docv:"OUT" ~doc
  and rows =
    let doc =
      "Render only rows $(docv), both included, counted from 0 at the top. \
       The picture holds just these rows, and says in its file where they \
       belong: $(b,raylab join) puts such bands together."
    in
    value & opt (some rows) None & info [ "rows" ] ~docv:"A-B" ~doc
  and stats =
    let doc =
      "Print the rays by kind, hits, time and rays per second to standard \
       error."
    in
    value & flag & info [ "stats" ] ~doc
  and quiet =
    let doc =
      "Print neither progress nor warnings, nor where the picture went."
    in
    value & flag & info [ "q"; "quiet" ] ~doc
  in
  let make scene from_prompt allow view out format domains rows show stats
      quiet =
    {
      scene;
      from_prompt;
      allow;
      view;
      out;
      format;
      domains;
      rows;
      show;
      stats;
      quiet;
    }
  in
  Term.(
    const make $ Command.scene_arg $ Options.from_prompt $ Options.allow
    $ Options.view $ out $ Output.wanted $ Options.domains $ rows $ show
    $ stats $ quiet)

let default_show =
  let either = function Never -> If_there_is_a_display | show -> show in
  Term.(const either $ asked_for)

let default = Command.run Term.(const render $ options default_show)

let command term =
  let man =
    [
      `S Manpage.s_description;
      `P
        "Renders $(i,SCENE) and writes the picture to a file, which appears \
         whole or not at all. What is known to fail is told before there is \
         any work.";
      `P
        "A file that cannot be replaced, such as a mount point or one in a \
         folder that may not be written to, gets the finished picture copied \
         over it, which is told. A pipe, a device and what is open, such as \
         $(b,/dev/fd/3), are written through: what is there stays.";
      `P
        "While it works, and if standard error is a terminal, it shows how \
         far it is and how long the rest will take.";
    ]
  in
  Cmd.v
    (Command.info "render" ~doc:"render a scene to a picture file" man)
    term

let cmd = command (Command.run Term.(const render $ options asked_for))
let default_cmd = command default
