open Raylab_scene

let title = "raylab's scene from the prompt "

(* of the same length in every build *)
let mark =
  let build = Layout.digest ^ Sys.ocaml_version ^ string_of_int Sys.int_size in
  Digest.to_hex (Digest.string build)

let write channel (scene : Scene.t) =
  output_string channel title;
  output_string channel mark;
  Marshal.to_channel channel scene [];
  flush channel

let other_build =
  "the prompt and raylab are of different builds: install both again, \
   together (in a checkout dune build @install makes both)"

let not_whole = "the scene from the prompt is not whole"

let read_scene channel : (Scene.t, string) result =
  match Marshal.from_channel channel with
  | scene -> Ok scene
  | exception (End_of_file | Failure _) -> Error not_whole

let read channel =
  let next text =
    In_channel.really_input_string channel (String.length text)
  in
  if next title <> Some title then Error "this is no scene from the prompt"
  else if next mark <> Some mark then Error other_build
  else read_scene channel
