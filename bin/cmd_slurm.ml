open Cmdliner
open Raylab_scene
open Raylab_picture
open Raylab_slurm

type options = {
  scene : string;
  allow : string list;
  view : Options.view;
  out : string;
  bands : int;
  cores : int;
  submit : bool;
}

let or_write_error = function
  | Ok value -> value
  | Error message -> Command.write_error message

(* {1 What is asked for} *)

let absolute path =
  if not (Filename.is_relative path) then path
  else
    match Sys.getcwd () with
    | here -> Filename.concat here path
    | exception Sys_error reason ->
        Command.write_error
          (Printf.sprintf
             "%s is relative to the current folder, which cannot be found: %s"
             path reason)

let check_out { out; scene; _ } =
  if not (Target.has_name out) then
    Command.usage_error
      "option -o: a job has no standard output for a picture; name a file";
  Output.format out ~inputs:[ scene ] ~named:"the scene"

(* The job would find out at its very end. *)
let check_place path = or_write_error (Atomic_file.check ~path ~bytes:1)

let check_bands options { Camera.width; height; _ } =
  if options.bands > height then
    Command.usage_error "option --bands: the picture has only %d rows" height;
  let most = (height + options.bands - 1) / options.bands in
  match Picture_file.check_size Ppm ~width ~height:most with
  | Ok () -> ()
  | Error message ->
      Command.write_error
        ("the bands are too large, make more of them: " ^ message)

let check_whole format { Camera.width; height; _ } =
  or_write_error (Picture_file.check_format format ~width ~height)

let job options ~out { Camera.height; _ } =
  {
    Job.raylab = Sys.executable_name;
    view = Options.arguments options.view;
    height;
    bands = options.bands;
    cores = options.cores;
    out;
  }

(* {1 Submitting} *)

let is_on_path program =
  let is_program folder =
    try
      Unix.access (Filename.concat folder program) [ X_OK ];
      true
    with Unix.Unix_error _ -> false
  in
  Option.value ~default:"" (Sys.getenv_opt "PATH")
  |> String.split_on_char ':' |> List.exists is_program

let submit folder =
  let script = Folder.submit folder in
  if not (is_on_path "sbatch") then
    Command.write_error
      ("there is no sbatch on the PATH: this machine cannot submit to Slurm. \
        Where it can be done, run " ^ script);
  let pid =
    Unix.create_process script [| script |] Unix.stdin Unix.stdout Unix.stderr
  in
  match Unix.waitpid [] pid with
  | _, WEXITED 0 -> ()
  | _ -> Command.write_error (script ^ " has failed; it may be run again")

let slurm options () =
  let format = check_out options in
  let out = absolute options.out in
  check_place options.out;
  let reading, written =
    Command.read_scene ~allow:options.allow options.scene
  in
  let scene = Options.adjust options.view written in
  check_bands options scene.camera;
  check_whole format scene.camera;
  Output.protect options.out reading;
  Warnings.tell_as options.view options.scene reading;
  let folder = Filename.remove_extension out ^ ".slurm" in
  let job = job options ~out scene.camera
  and files = Copies.make reading.sources reading.named in
  or_write_error (Folder.write folder ~files job);
  if options.submit then submit folder
  else
    Command.say "wrote %s; to submit it, run %s" folder (Folder.submit folder)

(* {1 The command line} *)

let number =
  let parse text =
    match Options.natural text with
    | Some n when n >= 1 -> Ok n
    | _ -> Error (Printf.sprintf "'%s' is not a number of bands" text)
  in
  Options.conv parse ~docv:"N" Format.pp_print_int

let options =
  let open Arg in
  let out =
    let doc =
      "The picture that the job writes. Its extension says in which format: \
       $(b,.bmp), $(b,.png) or $(b,.ppm); without extension it is BMP. The \
       folder of the job lies beside it, under its name with $(b,.slurm)."
    in
    required & opt (some string) None & info [ "o"; "output" ] ~docv:"OUT" ~doc
  and bands =
    let doc =
      "Render the picture in $(docv) bands, each a task of the array."
    in
    required & opt (some number) None & info [ "bands" ] ~docv:"N" ~doc
  and cores =
    let doc = "Ask Slurm for $(docv) cores for each band, and use them." in
    value
    & opt Options.number_of_domains 1
    & info [ "j"; "domains" ] ~docv:"DOMAINS" ~doc
  and submit =
    let doc = "Submit the job as well." in
    value & flag & info [ "submit" ] ~doc
  in
  let make scene allow view out bands cores submit =
    { scene; allow; view; out; bands; cores; submit }
  in
  Term.(
    const make $ Command.scene_arg $ Options.allow $ Options.view $ out $ bands
    $ cores $ submit)

let cmd =
  let man =
    [
      `S Manpage.s_description;
      `P
        "Writes a job for Slurm: a folder with a copy of $(i,SCENE), and of \
         all that it includes, and three scripts, $(b,bands.sbatch), a job \
         array that renders a band a task, $(b,join.sbatch), which joins \
         them, and $(b,submit), which submits both. They are made to be read, \
         and may be edited. All nodes must see the folder and raylab under \
         the same paths.";
      `P
        "A band that fails is tried again, and so is one whose node is lost. \
         When the job is submitted again, only the bands that are missing are \
         rendered. Edits of $(i,SCENE) do not change a job that has been \
         written.";
      `S Manpage.s_environment;
      `P "$(b,RAYLAB), if the job has it, is the program that the scripts run.";
    ]
  in
  Cmd.v
    (Command.info "slurm" ~doc:"render a picture in bands, on a cluster" man)
    (Command.run Term.(const slurm $ options))
