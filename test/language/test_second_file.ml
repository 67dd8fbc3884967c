open Raylab_source
open Raylab_scene
open Raylab_language
open Test_support

(* Reads a file that is not the first one of its scene. *)
let read text =
  let sources =
    Sources.make ~name:"a.scene" "# the main file\n"
    |> Sources.add ~name:"b.scene" text
  in
  let file = List.nth (Sources.files sources) 1 in
  match Reader.parse sources file with
  | Ok { included; _ } -> Evaluate.scene sources included.syntax
  | Error error -> Error [ error ]

let check_error what expected text =
  match read text with
  | Ok _ -> Alcotest.failf "%s: no error" what
  | Error errors ->
      Expect.contains what ~part:expected (Read.show_errors errors)

let test_errors () =
  let objects = Read.with_header "objects\n" in
  check_error "of syntax" "b.scene:3:1-6: error: unknown"
    (objects ^ "speher 0 0 6 1 reflective");
  check_error "of a setting" "b.scene:1:9: error: imWidth"
    "imWidth 0 imHeight 3 canvWidth 8 canvHeight 6 depth 5";
  let text =
    objects ^ "sphere 0 0 6 1 reflective\nsphere 0 0 6 -1 reflective"
  in
  check_error "of a number" "b.scene:4:14-15: error: the radius" text;
  check_error "the line is shown" "    4 | sphere 0 0 6 -1 reflective" text

let test_places () =
  match read (Read.with_header "objects\nsphere 0 0 6 1 reflective") with
  | Error errors -> Alcotest.fail (Read.show_errors errors)
  | Ok scene ->
      let place (o : Object.t) =
        Option.map Provenance.to_string (Scene.provenance scene o.origin)
      in
      Alcotest.(check (list (option string)))
        "objects"
        [ Some "line 3 of b.scene" ]
        (List.map place scene.objects)

let suite =
  ( "Second file",
    [
      Alcotest.test_case "errors" `Quick test_errors;
      Alcotest.test_case "places" `Quick test_places;
    ] )
