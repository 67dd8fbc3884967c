(* Each errors/NAME.scene has an error, and errors/NAME.expected is all that is
   printed about it. The expected texts are written by hand. *)

open Raylab_language
open Test_support

let folder = "errors"
let read path = In_channel.with_open_bin path In_channel.input_all

let printed name =
  let source =
    Raylab_source.Sources.make ~name (read (Filename.concat folder name))
  in
  match Scene_file.parse source with
  | Ok _ -> Alcotest.failf "%s has no error" name
  | Error errors ->
      String.concat ""
        (List.map (Property.show Scene_error.pp) errors
        |> List.map (fun text -> text ^ "\n"))

let test name =
  let scene = name ^ ".scene" in
  Alcotest.test_case name `Quick (fun () ->
      Alcotest.(check string)
        scene
        (read (Filename.concat folder (name ^ ".expected")))
        (printed scene))

let names =
  Array.to_list (Sys.readdir folder)
  |> List.filter (String.ends_with ~suffix:".scene")
  |> List.map Filename.remove_extension
  |> List.sort String.compare

let suite = ("Error messages", List.map test names)
