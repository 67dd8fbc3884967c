let is_folder name = name = "." || name = ".."

let of_path path =
  let name = Filename.basename path in
  match String.lowercase_ascii (Filename.extension path) with
  | "" when String.starts_with ~prefix:"." name && not (is_folder name) ->
      Error (path ^ ": there is no name before the extension; put one there")
  | extension -> Ok extension
