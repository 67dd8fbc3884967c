(* Random well-formed programs end in a scene that prints and reads back, or in
   errors with places, within the budget. *)

open Raylab_scene
open Raylab_language
open Test_support

let programs =
  QCheck2.Gen.make_primitive ~gen:Random_program.scene ~shrink:(fun _ ->
      Seq.empty)

let printed = Format.asprintf "%a" Scene_file.print
let has_place { Scene_error.place; _ } = place <> None

let ends text =
  match Read.result text with
  | Error errors -> errors <> [] && List.for_all has_place errors
  | Ok scene -> (
      match Read.result (printed scene) with
      | Ok again -> Scene.equal scene again
      | Error _ -> false)

(* No name is unknown and nothing is in the wrong place: else the others would
   try little. *)
let is_of_the_language text =
  let sources = Raylab_source.Sources.make ~name:"test.scene" text in
  Result.is_ok
    (Reader.parse sources (List.hd (Raylab_source.Sources.files sources)))

(* What a scene is depends on nothing but its text. *)
let is_pure text = Read.result text = Read.result text

let test_often_scenes () =
  let random = Random.State.make [| 14 |] in
  let texts = List.init 200 (fun _ -> Random_program.scene random) in
  let right = List.filter (fun t -> Result.is_ok (Read.result t)) texts in
  Alcotest.(check bool)
    (Printf.sprintf "%d of 200 are scenes" (List.length right))
    true
    (List.length right > 40)

let holds name property =
  Property.holds name ~print:Fun.id ~count:300 programs property

let suite =
  ( "Random programs",
    [
      holds "a scene that reads back, or errors with places" ends;
      holds "are of the language" is_of_the_language;
      holds "the same twice" is_pure;
      Alcotest.test_case "many are scenes" `Quick test_often_scenes;
    ] )
