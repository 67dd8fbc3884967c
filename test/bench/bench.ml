(* The benchmark's command line. *)

open Cmdliner

type options = {
  scenes : Scenes.t list option;
  quick : bool;
  runs : int option;
  domains : int;
  no_povray : bool;
  output : string option;
  keep : string option;
}

let say message = Printf.eprintf "bench: %s\n%!" message

(* {1 What to do} *)

(* Up to 10,000 spheres everything takes a few seconds. *)
let is_quick (scene : Scenes.t) = scene.spheres <= 10_000

let scenes options =
  match options.scenes with
  | Some scenes -> scenes
  | None when options.quick -> List.filter is_quick Scenes.all
  | None -> Scenes.all

let plan options =
  {
    Trial.runs =
      Option.value options.runs ~default:(if options.quick then 2 else 5);
    domains = options.domains;
    povray = (not options.no_povray) && Option.is_some (Povray.version ());
  }

let rec remove_all path =
  if Sys.is_directory path then (
    Array.iter
      (fun name -> remove_all (Filename.concat path name))
      (Sys.readdir path);
    Sys.rmdir path)
  else Sys.remove path

let with_temporary_directory work =
  let dir = Filename.temp_dir "raylab-bench" "" in
  Fun.protect ~finally:(fun () -> remove_all dir) (fun () -> work dir)

let first_pixels runs =
  List.filter_map
    (fun _ ->
      match Measure.first_pixel () with
      | Ok seconds -> Some seconds
      | Error reason ->
          say reason;
          None)
    (List.init runs Fun.id)

(* A scene that fails is said and left out. *)
let trials plan scenes =
  with_temporary_directory (fun dir ->
      List.filter_map
        (fun scene ->
          match Trial.perform plan ~dir ~say scene with
          | Ok trial -> Some trial
          | Error reason ->
              say reason;
              None)
        scenes)

let povray_empty plan =
  if not plan.Trial.povray then []
  else
    with_temporary_directory (fun dir ->
        let path = Filename.concat dir "empty.pov" in
        Out_channel.with_open_bin path (fun channel ->
            output_string channel Povray.empty);
        let width = Scenes.width and height = Scenes.height in
        List.filter_map
          (fun _ ->
            Result.to_option (Povray.render ~threads:1 ~width ~height path))
          (List.init plan.runs Fun.id))

let measure options =
  let plan = plan options and scenes = scenes options in
  let machine = Machine.describe () in
  let first_pixel = first_pixels (2 * plan.runs) in
  let povray_empty = povray_empty plan in
  let trials = trials plan scenes in
  let page =
    Report.to_markdown { machine; plan; first_pixel; povray_empty; trials }
  in
  print_string page;
  Option.iter
    (fun path ->
      Out_channel.with_open_bin path (fun c -> output_string c page))
    options.output;
  if List.length trials = List.length scenes then 0 else 1

let write_only dir scenes =
  let write scene =
    match Trial.write_files ~dir ~povray:true scene with
    | Ok (scene_path, povray_path) ->
        say (Printf.sprintf "wrote %s and %s" scene_path povray_path);
        true
    | Error reason ->
        say reason;
        false
  in
  if List.for_all write scenes then 0 else 1

let main options =
  match options.keep with
  | Some dir -> write_only dir (scenes options)
  | None -> measure options

(* {1 Options} *)

let names = List.map (fun (s : Scenes.t) -> (s.name, s)) Scenes.all

let scenes =
  let doc =
    Printf.sprintf "Measure these scenes only, of %s."
      (String.concat ", " (List.map fst names))
  in
  Arg.(
    value
    & opt (some (list (enum names))) None
    & info [ "scenes" ] ~docv:"NAMES" ~doc)

let positive name =
  let parse text =
    match int_of_string_opt text with
    | Some n when n >= 1 -> Ok n
    | _ -> Error (`Msg (Printf.sprintf "%s is not a number of %s" text name))
  in
  Arg.conv (parse, Format.pp_print_int)

let options =
  let open Arg in
  let quick =
    let doc = "Two runs, and no scene of more than 10,000 spheres." in
    value & flag & info [ "quick" ] ~doc
  and runs =
    let doc = "Measure everything $(docv) times: by default 5 times." in
    value & opt (some (positive "runs")) None & info [ "runs" ] ~docv:"N" ~doc
  and domains =
    let doc =
      "Compare one domain with $(docv): by default with one for each core, \
       but at most 4."
    in
    value
    & opt (positive "domains") (Int.min 4 (Machine.cores ()))
    & info [ "domains" ] ~docv:"N" ~doc
  and no_povray =
    let doc = "Leave POV-Ray out, even where it is installed." in
    value & flag & info [ "no-povray" ] ~doc
  and output =
    let doc = "Write the results to $(docv) too, as Markdown." in
    value & opt (some string) None & info [ "output" ] ~docv:"FILE" ~doc
  and keep =
    let doc =
      "Measure nothing; write the scenes to the directory $(docv), for raylab \
       and for POV-Ray."
    in
    value & opt (some dir) None & info [ "write-scenes" ] ~docv:"DIR" ~doc
  in
  let make scenes quick runs domains no_povray output keep =
    { scenes; quick; runs; domains; no_povray; output; keep }
  in
  Term.(
    const make $ scenes $ quick $ runs $ domains $ no_povray $ output $ keep)

(* An interrupt ends the benchmark by an exception, which removes its files. *)
let () =
  Sys.catch_break true;
  let doc = "measure raylab's speed, beside POV-Ray's where it is installed" in
  let cmd = Cmd.v (Cmd.info "bench" ~doc) Term.(const main $ options) in
  exit (try Cmd.eval' ~catch:false cmd with Sys.Break -> 130)
