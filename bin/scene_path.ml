open Raylab_picture

let is_stream path = not (Target.has_name path)

let name path =
  if Target.is_standard_input path then "standard input" else path

let picture ?format path =
  if is_stream path then
    Error
      (Printf.sprintf
         "a scene from %s has no name to call its picture after: say where it \
          goes with -o"
         (name path))
  else Ok (Output.beside ?format path)
