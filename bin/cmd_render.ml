open Cmdliner
open Raylab_parallel
open Raylab_scene
open Raylab_tracer
open Raylab_picture

type options = {
  scene : string;
  view : Options.view;
  out : string option;
  domains : int option;
  rows : Render.rows option;
  stats : bool;
  quiet : bool;
}

(* {1 Where the picture goes} *)

type target = Standard_output | File of string

let target { scene; out; _ } =
  match out with
  | Some "-" -> Standard_output
  | Some "" -> Command.usage_error "option -o: the name of the file is empty"
  | Some path -> File path
  | None when scene = "-" ->
      Command.usage_error
        "a scene from standard input has no name to call its picture after: \
         say where it goes with -o"
  | None -> File (Filename.remove_extension scene ^ ".bmp")

let check_target options target =
  match target with
  | Standard_output -> Picture_file.Bmp
  | File path -> (
      if Command.is_same_file path options.scene then
        Command.usage_error "%s is the scene; the picture would replace it" path;
      match Picture_file.format_of_path path with
      | Ok format -> format
      | Error message -> Command.usage_error "%s" message)

let write format target picture =
  let written =
    match target with
    | Standard_output -> Picture_file.output format stdout picture
    | File path -> Picture_file.save format ~path picture
  in
  match written with
  | Ok () -> ()
  | Error message -> Command.write_error message

(* {1 Rendering} *)

let check_rows options { Camera.height; _ } =
  match options.rows with
  | Some { last; _ } when last >= height ->
      Command.usage_error
        "option --rows: the picture has no row %d; its rows are 0 to %d" last
        (height - 1)
  | _ -> ()

let check_size format options { Camera.width; height; _ } =
  let height =
    match options.rows with
    | Some { first; last } -> last - first + 1
    | None -> height
  in
  match Picture_file.check_size format ~width ~height with
  | Ok () -> ()
  | Error message -> Command.write_error message

let print_stats (tally : Tally.t) ~pixels ~seconds =
  let rays = Tally.rays tally in
  let count name n = Command.tell "%-15s %12d" name n in
  count "primary rays" tally.primary;
  count "reflected rays" tally.reflected;
  count "shadow rays" tally.shadow;
  count "rays" rays;
  count "hits" tally.hits;
  count "lights blocked" tally.blocked;
  count "pixels" pixels;
  Command.tell "%-15s %12.3f s" "time" seconds;
  Command.tell "%-15s %12.0f" "rays per second" (float_of_int rays /. seconds)

let render options () =
  let target = target options in
  let format = check_target options target in
  let scene = Options.adjust options.view (Command.load_scene options.scene) in
  check_rows options scene.camera;
  check_size format options scene.camera;
  let progress = Progress.start ~quiet:options.quiet in
  let started = Unix.gettimeofday () in
  let domains =
    Option.value options.domains ~default:(Parallel.default_domains ())
  in
  let picture, tally =
    Render.picture ~domains ?rows:options.rows
      ~on_progress:(Progress.update progress)
      (Trace.prepare ~domains scene)
  in
  let seconds = Unix.gettimeofday () -. started in
  Progress.clear progress;
  write format target picture;
  (match target with
  | File path when not options.quiet -> Command.say "wrote %s" path
  | _ -> ());
  if options.stats then
    print_stats tally
      ~pixels:(Picture.width picture * Picture.height picture)
      ~seconds

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

let domains =
  let parse text =
    match Options.natural text with
    | Some n when 1 <= n && n <= Parallel.max_domains -> Ok n
    | _ ->
        Error
          (Printf.sprintf "'%s' is not a number of domains from 1 to %d" text
             Parallel.max_domains)
  in
  Options.conv parse ~docv:"DOMAINS" Format.pp_print_int

let options =
  let open Arg in
  let out =
    let doc =
      "Write the picture to $(docv). Its extension says in which format: \
       $(b,.bmp), $(b,.png) or $(b,.ppm); without extension it is BMP. $(b,-) \
       is standard output, in BMP. By default the picture goes beside the \
       scene, under its name with $(b,.bmp); a picture that is already there \
       is replaced."
    in
    value & opt (some string) None & info [ "o"; "output" ] ~docv:"OUT" ~doc
  and domains =
    let doc =
      "Render on $(docv) domains at once, by default one for each core. The \
       picture is the same, byte for byte."
    in
    value
    & opt (some domains) None
    & info [ "j"; "domains" ] ~docv:"DOMAINS" ~doc
  and rows =
    let doc =
      "Render only rows $(docv), both included, counted from 0 at the top. The \
       picture holds just these rows."
    in
    value & opt (some rows) None & info [ "rows" ] ~docv:"A-B" ~doc
  and stats =
    let doc =
      "Print the rays by kind, hits, time and rays per second to standard \
       error."
    in
    value & flag & info [ "stats" ] ~doc
  and quiet =
    let doc = "Print neither progress nor where the picture went." in
    value & flag & info [ "q"; "quiet" ] ~doc
  in
  let make scene view out domains rows stats quiet =
    { scene; view; out; domains; rows; stats; quiet }
  in
  Term.(
    const make $ Command.scene_arg $ Options.view $ out $ domains $ rows $ stats
    $ quiet)

let default = Command.run Term.(const render $ options)

let cmd =
  let man =
    [
      `S Manpage.s_description;
      `P
        "Renders $(i,SCENE) and writes the picture to a file, which appears \
         whole or not at all.";
      `P
        "While it works, and if standard error is a terminal, it shows how far \
         it is and how long the rest will take.";
    ]
  in
  Cmd.v
    (Command.info "render" ~doc:"render a scene to a picture file" man)
    default
