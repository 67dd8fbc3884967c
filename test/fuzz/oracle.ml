open Raylab_scene
open Raylab_language
open Raylab_tracer

let parse text =
  Scene_file.parse ~access:Test_files.Mesh_texts.access
    (Raylab_source.Sources.make ~name:"fuzz" text)

let printed pp value = Format.asprintf "%a" pp value

(* {1 Errors} *)

let is_clean text =
  String.is_valid_utf_8 text
  && String.for_all (fun c -> (c >= ' ' && c <> '\x7f') || c = '\n') text

let bytes_before_text text =
  if String.starts_with ~prefix:"\xef\xbb\xbf" text then 3 else 0

(* The lengths of the lines, which LF, CR or CR LF end. *)
let line_lengths text =
  let length = String.length text in
  let rec cut start at lengths =
    if at = length then List.rev ((at - start) :: lengths)
    else
      match text.[at] with
      | '\r' when at + 1 < length && text.[at + 1] = '\n' ->
          cut (at + 2) (at + 2) ((at - start) :: lengths)
      | '\r' | '\n' -> cut (at + 1) (at + 1) ((at - start) :: lengths)
      | _ -> cut start (at + 1) lengths
  in
  let from = bytes_before_text text in
  Array.of_list (cut from from [])

(* What is missing would stand one column after the line. *)
let is_inside lengths { Scene_error.place; _ } =
  match place with
  | None -> false
  | Some { line; first; last } ->
      1 <= line
      && line <= Array.length lengths
      && 1 <= first && first <= last
      && last <= lengths.(line - 1) + 1

let complaint_of_errors text errors =
  let lengths = line_lengths text in
  if errors = [] then Some "an error without errors"
  else if not (List.for_all (is_inside lengths) errors) then
    Some "an error's place is not in the text"
  else if
    not (List.for_all (fun e -> is_clean (printed Scene_error.pp e)) errors)
  then Some "an error prints control characters"
  else None

(* {1 Scenes} *)

let most_side = 4
let most_depth = 20

(* The same scene, small enough to be rendered thousands of times. *)
let small (scene : Scene.t) =
  let { Camera.width; height; _ } = scene.camera in
  let side n = Int.min n most_side in
  let camera =
    Camera.with_size ~width:(side width) ~height:(side height) scene.camera
  in
  Scene.make camera ~ambient:scene.ambient
    ~ray_depth:(Int.min scene.ray_depth most_depth)
    ~lights:scene.lights ~objects:scene.objects
  |> Scene.with_sky scene.background

let complaint_of_pixel prepared ~x ~y =
  let color = Tracer.pixel prepared ~x ~y in
  let explanation = Explain.pixel prepared ~x ~y in
  let complain what = Some (Printf.sprintf "pixel (%d, %d): %s" x y what) in
  if not (Finite.color color) then complain "its colour is not finite"
  else if not (Finite.explanation explanation) then
    complain "its explanation has a number that is not finite"
  else if not (Color.equal color explanation.color) then
    complain "its explanation has another colour"
  else None

let complaint_of_picture scene =
  let scene = small scene in
  let prepared = Prepared.make scene in
  let { Camera.width; height; _ } = scene.camera in
  let pixel k = complaint_of_pixel prepared ~x:(k mod width) ~y:(k / width) in
  Seq.find_map pixel (Seq.init (width * height) Fun.id)

let complaint_of_scene scene =
  match parse (printed Scene_file.print scene) with
  | Error _ -> Some "the printed scene is in error"
  | Ok again when not (Scene.equal scene again) ->
      Some "the printed scene is another"
  | Ok _ -> complaint_of_picture scene

let whatever_happens f =
  match f () with
  | complaint -> complaint
  | exception Unpainted.Found _ -> None (* it is told *)
  | exception failure -> Some (Printexc.to_string failure)

let complaint text =
  whatever_happens (fun () ->
      match parse text with
      | Error errors -> complaint_of_errors text errors
      | Ok scene -> complaint_of_scene scene)

let complaint_unless_error text =
  whatever_happens (fun () ->
      match parse text with
      | Error errors -> complaint_of_errors text errors
      | Ok _ -> Some "it is no error")
