open Raylab_picture

let beside scene = Filename.remove_extension scene ^ ".bmp"

let format path ~inputs ~named =
  if path = "" then
    Command.usage_error "option -o: the name of the file is empty";
  if List.exists (Command.is_same_file path) inputs then
    Command.usage_error "%s is %s; the picture would replace it" path named;
  match Picture_file.format_of_path path with
  | Ok format -> format
  | Error message -> Command.usage_error "%s" message

let remove_temporary_files () =
  let remove path = try Sys.remove path with Sys_error _ -> () in
  List.iter remove (Atomic_file.temporary ())
