open Raylab_scene
open Raylab_language
open Raylab_toplevel

let text =
  {|imWidth 8 imHeight 6 canvWidth 4 canvHeight 3 depth 4 samples 4
let ball(n) = union for i = 1 to n sphere i 0 n 1 luminous red end end
lights
  directional 1 white 0 -1 0
objects
  for k = 1 to 2 by 1
    ball(k) stretched 1 2 3
  end
  difference box 0 0 0 1 1 1 diffusive blue sphere 0 0 0 1 reflective end
|}

let scene =
  match Scene_file.parse (Raylab_source.Sources.make ~name:"s" text) with
  | Ok scene -> scene
  | Error _ -> invalid_arg "test_handover"

let places (scene : Scene.t) =
  List.map
    (fun (o : Object.t) ->
      Option.fold ~none:"unknown" ~some:Provenance.to_string
        (Scene.provenance scene o.origin))
    scene.objects

(* [handed_over write] is what is read of what [write] has written. *)
let handed_over write =
  let path = Filename.temp_file "raylab" "" in
  Fun.protect ~finally:(fun () -> Sys.remove path) @@ fun () ->
  Out_channel.with_open_bin path write;
  In_channel.with_open_bin path Handover.read

let written scene =
  let path = Filename.temp_file "raylab" "" in
  Fun.protect ~finally:(fun () -> Sys.remove path) @@ fun () ->
  Out_channel.with_open_bin path (fun channel -> Handover.write channel scene);
  In_channel.with_open_bin path In_channel.input_all

let bytes text = handed_over (fun channel -> output_string channel text)

let test_same () =
  match bytes (written scene) with
  | Error message -> Alcotest.fail message
  | Ok found ->
      Alcotest.(check bool) "scene" true (Scene.equal scene found);
      Alcotest.(check (list string)) "places" (places scene) (places found)

let refused name expected text =
  match bytes text with
  | Ok _ -> Alcotest.failf "%s: no error" name
  | Error message -> Alcotest.(check string) name expected message

let no_scene = "this is no scene from the prompt"

let test_refused () =
  let whole = written scene in
  let length = String.length whole in
  refused "nothing" no_scene "";
  refused "a scene file" no_scene text;
  let changed = Bytes.of_string whole in
  Bytes.set changed 40 (if whole.[40] = '0' then '1' else '0');
  refused "another build"
    "the prompt and raylab are of different builds: install both again, \
     together (in a checkout dune build @install makes both)"
    (Bytes.to_string changed);
  refused "cut off" "the scene from the prompt is not whole"
    (String.sub whole 0 (length - 1));
  refused "only its head" "the scene from the prompt is not whole"
    (String.sub whole 0 70)

let suite =
  ( "Handover",
    [
      Alcotest.test_case "the same scene" `Quick test_same;
      Alcotest.test_case "what is refused" `Quick test_refused;
    ] )
