open Cmdliner

let manual = ("raylab-scene", 5)

(* Where installers put the folder of documents, from that of programs. *)
let folder () =
  let prefix = Filename.(dirname (dirname Sys.executable_name)) in
  [ "doc"; "share/doc" ]
  |> List.map (fun doc ->
         List.fold_left Filename.concat prefix [ doc; "raylab" ])
  |> List.find_opt (fun folder ->
         Sys.file_exists (Filename.concat folder "scenes"))

let where =
  match folder () with
  | Some folder -> Printf.sprintf "$(b,%s)" (Manpage.escape folder)
  | None ->
      "The folder $(b,doc/raylab) of what raylab is installed in, such as \
       $(b,~/.local/doc/raylab),"

let blocks =
  let name, section = manual in
  [
    `P
      (Printf.sprintf
         "The language of scenes has a manual, $(b,%s)(%d). %s holds it with \
          pictures, $(b,doc/language.md), a gallery of scenes, $(b,scenes), \
          and a lesson at the prompt, $(b,scenes/why-black.md)."
         name section where);
  ]
