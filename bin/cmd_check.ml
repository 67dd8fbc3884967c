open Cmdliner
open Raylab_language
open Raylab_explanation
open Raylab_picture

type form = Text | Json | Expanded

let tell path reading =
  (match reading.Scene_file.scene with
  | Ok _ -> ()
  | Error errors -> List.iter Command.print_error errors);
  Warnings.tell path reading

let print text =
  let print () =
    Result.bind (Atomic_file.check_output ()) (fun () ->
        Atomic_file.print text)
  in
  Result.iter_error Command.write_error (Signals.for_readers print)

let print_expanded scene = print (Format.asprintf "%a" Scene_file.expand scene)

(* The problems of a scene, as far as they are wanted, and whether it is
   right. *)
let check_one ~access form path =
  let reading = Scene_file.read ~access path in
  let problems =
    match form with
    | Json -> Problem.of_reading path reading
    | Text | Expanded ->
        tell path reading;
        []
  in
  if form = Expanded then Result.iter print_expanded reading.scene;
  ((path, problems), Result.is_ok reading.scene)

let check allow form paths () =
  if form = Expanded && List.length paths > 1 then
    Command.usage_error "option --expand: only one scene can be printed";
  let access = Raylab_disk.Disk.access ~allow in
  (* every scene is read, also after one in error *)
  let checked = List.map (check_one ~access form) paths in
  if form = Json then
    print (Json.to_string (Problem_json.document (List.map fst checked)));
  if not (List.for_all snd checked) then
    raise (Command.Ended Exit_code.scene_error)

let scenes =
  let doc = "The scene files, or $(b,-) for standard input." in
  Arg.(non_empty & pos_all string [] & info [] ~docv:"SCENE" ~doc)

let form =
  let json =
    let doc =
      "Print what is found as JSON to standard output, for other programs; \
       see $(b,JSON) below."
    in
    (Json, Arg.info [ "json" ] ~doc)
  and expanded =
    let doc =
      "Print the scene as it was evaluated to standard output: one light or \
       object a line, in the language of scenes, without names and loops, and \
       behind each, as a comment, where it comes from."
    in
    (Expanded, Arg.info [ "expand" ] ~doc)
  in
  Arg.(value & vflag Text [ json; expanded ])

let cmd =
  let man =
    [
      `S Manpage.s_description;
      `P
        "Reads each $(i,SCENE) and prints every error and warning to standard \
         error. Renders nothing. Warnings do not change the exit status.";
      `S "JSON";
      `P "With $(b,--json) the output is";
      `Pre Problem_json.schema;
      `P
        "New members may be added; a change that breaks readers gets a new \
         version.";
    ]
  in
  Cmd.v
    (Command.info "check" ~doc:"report the errors and warnings of scenes" man)
    (Command.run Term.(const check $ Options.allow $ form $ scenes))
