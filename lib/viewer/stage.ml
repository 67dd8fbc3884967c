type t = Reading | Rendering | Took of float | In_error of string

let title stage ~name ~size:(width, height) ~part =
  let sized rest = Printf.sprintf "%s, %d x %d: %s" name width height rest in
  match stage with
  | Reading -> name
  | Rendering -> sized (Printf.sprintf "%d %%" (int_of_float (100. *. part)))
  | Took seconds -> sized (Printf.sprintf "%.2f s" seconds)
  | In_error _ -> name ^ ": error"
