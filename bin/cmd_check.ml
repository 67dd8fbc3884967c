open Cmdliner
open Raylab_geometry
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

(* What cannot be seen of a mesh in the text of a scene. *)
let survey path { Scene_file.meshes; _ } =
  let tell mesh =
    Printf.sprintf "%s: mesh %s: %s" path (Mesh.file mesh)
      (Mesh_survey.to_string (Mesh_survey.make mesh))
  in
  let line mesh = Raylab_source.Printable.text (tell mesh) ^ "\n" in
  if meshes <> [] then print (String.concat "" (List.map line meshes))

let print_expanded scene = print (Format.asprintf "%a" Scene_file.expand scene)

(* What JSON tells of a scene, if that is wanted, and whether it is right. *)
let check_one ~access form path =
  let reading = Scene_file.read ~access path in
  let found =
    match form with
    | Json ->
        let problems = Problem.of_reading path reading in
        [ { Problem_json.path; problems; meshes = reading.meshes } ]
    | Text ->
        tell path reading;
        survey path reading;
        []
    | Expanded ->
        tell path reading;
        Result.iter print_expanded reading.scene;
        []
  in
  (found, Result.is_ok reading.scene)

let check allow form paths () =
  if form = Expanded && List.length paths > 1 then
    Command.usage_error "option --expand: only one scene can be printed";
  let access = Raylab_disk.Disk.access ~allow in
  (* every scene is read, also after one in error *)
  let checked = List.map (check_one ~access form) paths in
  if form = Json then
    print
      (Json.to_string (Problem_json.document (List.concat_map fst checked)));
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
      `P
        "Of each mesh it prints to standard output how many triangles it has, \
         from where to where it goes, whether it is closed, or else where it \
         is open, and which way its normals point.";
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
