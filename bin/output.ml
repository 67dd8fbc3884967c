open Raylab_picture

let beside scene = Filename.remove_extension scene ^ ".bmp"

let format ~scene path =
  if path = "" then
    Command.usage_error "option -o: the name of the file is empty";
  if Command.is_same_file path scene then
    Command.usage_error "%s is the scene; the picture would replace it" path;
  match Picture_file.format_of_path path with
  | Ok format -> format
  | Error message -> Command.usage_error "%s" message
