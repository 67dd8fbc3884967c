open Cmdliner
open Raylab_language
open Raylab_picture

let beside ?(format = Picture_file.Bmp) scene =
  Scene_file.without_extension scene ^ Picture_file.extension format

let protect path reading =
  let { Scene_file.sources; named; _ } = reading in
  let path_of { Raylab_source.Sources.path; _ } = path in
  let files =
    List.map path_of (Raylab_source.Sources.files sources) @ List.map snd named
  in
  if path <> "-" && List.exists (Command.is_same_file path) files then
    Command.usage_error
      "%s is a file of the scene; the picture would replace it" path

let format ?wanted path ~inputs ~named =
  if path = "" then
    Command.usage_error "option -o: the name of the file is empty";
  if path <> "-" && List.exists (Command.is_same_file path) inputs then
    Command.usage_error "%s is %s; the picture would replace it" path named;
  match Picture_file.format_of_path ?default:wanted path with
  | Error message -> Command.usage_error "%s" message
  | Ok format when Option.value wanted ~default:format = format -> format
  | Ok _ ->
      Command.usage_error
        "%s: the extension says another format than --format does; leave one \
         of them out"
        path

let remove_temporary_files () =
  let remove path = try Sys.remove path with Sys_error _ -> () in
  List.iter remove (Atomic_file.temporary ())

(* {1 The option} *)

let name format =
  let extension = Picture_file.extension format in
  String.sub extension 1 (String.length extension - 1)

let wanted =
  let parse text =
    let extension = "." ^ String.lowercase_ascii text in
    match List.assoc_opt extension Picture_file.formats with
    | Some format -> Ok format
    | None ->
        Error
          (Printf.sprintf
             "'%s' is not a picture format: expected bmp, png or ppm" text)
  in
  let format =
    Options.conv parse ~docv:"FORMAT" (fun ppf format ->
        Format.pp_print_string ppf (name format))
  in
  let doc =
    "Write the picture in $(docv): $(b,bmp), $(b,png) or $(b,ppm). The \
     extension of $(i,OUT), if there is one, must say the same."
  in
  Arg.(value & opt (some format) None & info [ "format" ] ~docv:"FORMAT" ~doc)
