open Raylab_scene
open Raylab_tracer
open Raylab_toplevel
open Test_support

(* Whatever is called pp serves Format's %a: options belong to a pp_with. *)

let interfaces () =
  let rec below directory =
    Sys.readdir directory |> Array.to_list |> List.sort compare
    |> List.concat_map (fun name ->
           let path = Filename.concat directory name in
           if Sys.is_directory path then below path
           else if Filename.check_suffix name ".mli" then [ path ]
           else [])
  in
  below "../../lib"

let read path = In_channel.with_open_bin path In_channel.input_all

(* [words text] is [text] without line ends, each word after one blank. *)
let words text =
  String.map (function '\n' -> ' ' | c -> c) text
  |> String.split_on_char ' '
  |> List.filter (( <> ) "")

(* The values of an interface whose names begin with pp, and their types. *)
let printers path =
  let rec find found = function
    | "val" :: name :: ":" :: rest when String.starts_with ~prefix:"pp" name ->
        let rec type_of = function
          | ("(**" | "val" | "end") :: _ | [] -> []
          | word :: rest -> word :: type_of rest
        in
        find ((path, name, String.concat " " (type_of rest)) :: found) rest
    | _ :: rest -> find found rest
    | [] -> List.rev found
  in
  find [] (words (read path))

let takes_one_value type_ =
  match String.split_on_char '>' type_ with
  | [ "Format.formatter -"; value; " unit" ] ->
      not (String.contains value ':' || String.contains value '?')
  | _ -> false

let test_types () =
  let printers = List.concat_map printers (interfaces ()) in
  Alcotest.(check bool) "some are found" true (List.length printers > 15);
  List.iter
    (fun (path, name, type_) ->
      if not (String.ends_with ~suffix:"_with" name) then
        Alcotest.(check bool)
          (Printf.sprintf "%s: %s : %s" path name type_)
          true (takes_one_value type_))
    printers

(* {1 Lines} *)

let lines = String.split_on_char '\n'

let print ~margin pp value =
  let buffer = Buffer.create 80 in
  let ppf = Format.formatter_of_buffer buffer in
  Format.pp_set_margin ppf margin;
  Format.fprintf ppf "%a@?" pp value;
  Buffer.contents buffer

let test_places () =
  let check expected =
    let text = String.concat " " expected in
    Alcotest.(check (list string))
      text expected
      (lines (print ~margin:30 (Broken.at_words Format.pp_print_string) text)
      |> List.map String.trim)
  in
  check [ "short enough" ];
  check [ "sphere centre (1.25, 2.5, 3)"; "radius 0.123457" ];
  check [ "mixed 0.333333"; "diffusive 0.4 0.12345 0.2 0.5"; "reflective" ];
  check [ "(0.1, 0.2, 0.34567)"; "+ t (0.12345, 0.67890, 0)" ];
  check [ "emitted rgb 1 0.123456 0"; "+ diffused rgb 0 0 0"; "= rgb 1 0 0" ]

(* As the prompt does, below the value's name. Words stay as they are. *)
let is_broken_well pp value =
  let below ppf = Format.fprintf ppf "@[<2>val value : Module.t =@ %a@]" pp in
  let shown = print ~margin:80 below value in
  List.for_all (fun line -> String.length line <= 80) (lines shown)
  && words shown = words (print ~margin:100_000 below value)

let explained (e : Explain.t) =
  is_broken_well Printers.explain e
  && is_broken_well Printers.outcome e.outcome
  && List.for_all (is_broken_well Printers.term) e.terms
  &&
  match e.outcome with
  | Hit h ->
      is_broken_well Printers.hit h.hit
      && is_broken_well Printers.lobes h.lobes
      && List.for_all (is_broken_well Printers.explain_light) h.lights
  | Missed | Chain_ended | Too_faint -> true

let ray_told trace ray =
  is_broken_well Printers.ray ray
  && Seq.for_all (is_broken_well Printers.event) (Explain.steps trace ray)
  && explained (Explain.ray trace ray)

let all_told (scene : Scene.t) =
  is_broken_well Printers.scene scene
  && is_broken_well Printers.camera scene.camera
  && List.for_all (is_broken_well Printers.light) scene.lights
  && List.for_all (is_broken_well Printers.object_) scene.objects
  && Seq.for_all
       (ray_told (Prepared.make scene))
       (Camera.primary_rays scene.camera)

let narrow name number =
  Property.holds name ~count:100 ~print:(Property.show Scene.pp)
    (Generate.scene ~max_side:4 number)
    all_told

let suite =
  ( "Printing",
    [
      Alcotest.test_case "types" `Quick test_types;
      Alcotest.test_case "where lines break" `Quick test_places;
      narrow "no value is wider than a terminal" Generate.everyday;
      narrow "nor with numbers of any size" Generate.extreme;
    ] )
