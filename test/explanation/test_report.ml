open Raylab_scene
open Raylab_tracer
open Raylab_explanation
open Test_support
open Build

let print ?swatches pixel =
  let pp ppf = Report.pp_pixel_with ?swatches ppf in
  Format.asprintf "%a" pp pixel

let lines = String.split_on_char '\n'
let is_narrow line = String.length line <= 80

let narrow =
  Any.holds "no line is longer than 80 columns" (fun scene ->
      List.for_all
        (fun pixel -> List.for_all is_narrow (lines (print pixel)))
        (Any.explained scene))

let is_plain c = c = '\n' || (' ' <= c && c <= '~')

let plain =
  Any.holds "no control characters" (fun scene ->
      List.for_all
        (fun pixel -> String.for_all is_plain (print pixel))
        (Any.explained scene))

(* [without_escapes text] is [text] without the patches of colour. *)
let without_escapes text =
  let rec copy = function
    | [] -> []
    | part :: rest ->
        let from = String.index part 'm' + 1 in
        String.sub part from (String.length part - from) :: copy rest
  in
  match String.split_on_char '\027' text with
  | first :: rest -> String.concat "" (first :: copy rest)
  | [] -> ""

let swatches =
  Any.holds "patches of colour change no word" (fun scene ->
      let words text =
        List.filter (( <> ) "")
          (List.concat_map (String.split_on_char ' ') (lines text))
      in
      List.for_all
        (fun pixel ->
          let shown =
            without_escapes (print ~swatches:Swatch.True_color pixel)
          in
          words shown = words (print pixel)
          && List.for_all is_narrow (lines shown))
        (Any.explained scene))

(* {1 Long chains} *)

let facing_mirrors ray_depth =
  let mirror z = plane (v 0. 0. z) (v 0. 0. 1.) Surface.reflective in
  let scene =
    Scene.make ~ray_depth ~objects:[ mirror 4.; mirror (-6.) ] (camera ())
  in
  Explain.pixel (Prepared.make scene) ~x:0 ~y:0

let test_long () =
  let text = print (facing_mirrors 100) in
  Alcotest.(check bool) "narrow" true (List.for_all is_narrow (lines text));
  Expect.contains "all rays" ~part:"ray 100, mirrored:" text;
  Expect.contains "the end" ~part:"the chain has ended" text

let test_very_long () =
  let length = if Javascript.here then 300 else 20_000 in
  let pixel = facing_mirrors length in
  let last = Printf.sprintf "ray %d, mirrored:" (length + 1) in
  Expect.contains "text" ~part:last (print pixel);
  Expect.contains "JSON" ~part:"chain ended"
    (Json.to_string (Json.document [ pixel ]))

(* {1 Surfaces that vary} *)

(* The ray through the middle meets the wall at (0, 0, 4), where it was written
   at (0.5, 0, 4): in the second cube of half a unit. *)
let test_checker () =
  let wall surface modifiers =
    let wall = plane (v 0. 0. 4.) (v 0. 0. 1.) surface in
    let change = Raylab_geometry.Change.of_modifiers modifiers in
    let objects = [ Object.transformed change wall ] in
    let camera = camera ~width:1 ~height:1 () in
    print
      (Explain.pixel (Prepared.make (Scene.make ~objects camera)) ~x:0 ~y:0)
  in
  let matt = Surface.diffusive Color.white in
  let checker = Surface.checker 0.5 Surface.reflective matt in
  let check what part surface modifiers =
    Expect.contains what ~part (wall surface modifiers)
  in
  check "where it is written" "\n  the checker is a mirror at (0, 0, 4)\n"
    checker [];
  check "moved"
    "\n  the checker is white at (0.5, 0, 4) in its own coordinates\n" checker
    [ Translated (v (-0.5) 0. 0.) ];
  check "in a mix" "\n  which is mixed 0.5 reflective at (0, 0, 4)\n"
    (Surface.mixed [ (0.5, checker) ])
    [];
  check "which it is" "a white plane (object 1), with no light" checker
    [ Translated (v (-0.5) 0. 0.) ]

let suite =
  ( "Report",
    [
      Alcotest.test_case "a checker" `Quick test_checker;
      Alcotest.test_case "long chains" `Quick test_long;
      Alcotest.test_case "very long chains" `Quick test_very_long;
    ]
    @ narrow @ plain @ swatches )
