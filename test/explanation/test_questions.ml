open Raylab_scene
open Raylab_tracer
open Raylab_language
open Raylab_explanation
open Test_support

let scenes = Hashtbl.create 16

(* Each scene of the gallery is read once. *)
let load name =
  match Hashtbl.find_opt scenes name with
  | Some scene -> scene
  | None -> (
      let path = Printf.sprintf "../../scenes/%s.scene" name in
      match Scene_file.load ~access:Test_files.Nearby.access path with
      | Ok scene ->
          let scene = Prepared.make scene in
          Hashtbl.add scenes name scene;
          scene
      | Error _ -> Alcotest.failf "%s is in error" path)

(* [one_line text] is [text] with every run of white space a single blank. *)
let one_line text =
  String.split_on_char '\n' text
  |> List.concat_map (String.split_on_char ' ')
  |> List.filter (( <> ) "")
  |> String.concat " "

let with_samples samples prepared =
  match samples with
  | None -> prepared
  | Some samples ->
      let { Prepared.scene; _ } = prepared in
      let film = Film.with_samples samples scene.film in
      Prepared.make (Scene.with_film film scene)

let test { Questions.scene; samples; x; y; why; summary; tree } =
  let answer () =
    let scene = with_samples samples (load scene) in
    let pixel = Explain.pixel scene ~x ~y in
    let said = Summary.of_pixel pixel
    and printed = one_line (Format.asprintf "%a" Report.pp_pixel pixel) in
    List.iter (fun part -> Expect.contains "summary" ~part said) summary;
    List.iter (fun part -> Expect.contains "tree" ~part printed) tree
  in
  let name = Printf.sprintf "%s %d,%d: %s" scene x y why in
  Alcotest.test_case name `Quick answer

let suite = ("Questions", List.map test Questions.all)
