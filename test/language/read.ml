open Raylab_language
open Test_support

let result text =
  Scene_file.parse ~access:Test_support.Meshes.access
    (Raylab_source.Sources.make ~name:"test.scene" text)

let show_errors errors =
  String.concat "\n" (List.map (Property.show Scene_error.pp) errors)

let scene text =
  match result text with
  | Ok scene -> scene
  | Error errors -> Alcotest.failf "%s\nin: %s" (show_errors errors) text

let with_header text =
  "imWidth 4 imHeight 3 canvWidth 8 canvHeight 6 depth 5\n" ^ text

let camera =
  Build.camera ~width:4 ~height:3 ~canvas_width:8. ~canvas_height:6. ~depth:5.
    ()

let errors text =
  match result text with
  | Ok _ -> Alcotest.failf "no error in: %s" text
  | Error errors -> errors

(* The lines of a block are of the scene or marks of errors. *)
let is_mark line = String.starts_with ~prefix:"^" (String.trim line)

let error_of_mark number line =
  let first = String.index line '^' and last = String.rindex line '^' in
  let message = String.sub line (last + 1) (String.length line - last - 1) in
  (number, first + 1, last + 1, String.trim message)

let rec errors_of_marks number = function
  | [] -> []
  | line :: rest when is_mark line ->
      let error = error_of_mark number line in
      error :: errors_of_marks number rest
  | _ :: rest -> errors_of_marks (number + 1) rest

(* A mark may leave out the end of a long message. *)
let same_error (line, first, last, expected) (line', first', last', message) =
  (line, first, last) = (line', first', last')
  &&
  if String.ends_with ~suffix:"..." expected then
    let prefix = String.sub expected 0 (String.length expected - 3) in
    String.starts_with ~prefix message
  else expected = message

let found { Scene_error.place; message; _ } =
  match place with
  | Some { line; first; last } -> (line, first, last, message)
  | None -> (0, 0, 0, message)

let pp_found ppf (line, first, last, message) =
  Format.fprintf ppf "%d:%d-%d: %s" line first last message

let check_errors what block =
  let lines = List.tl (String.split_on_char '\n' block) in
  let text = List.filter (fun line -> not (is_mark line)) lines in
  Alcotest.(check (list (testable pp_found same_error)))
    what (errors_of_marks 0 lines)
    (List.map found (errors (String.concat "\n" text)))
