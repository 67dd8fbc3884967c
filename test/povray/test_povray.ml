(* Every scene in scenes/ is rendered by raylab and, where it is installed, by
   POV-Ray 3.7, which knows nothing of our mathematics: at least 98.5 % of the
   pixels must be within 3 levels. The others are at edges, where one of two
   colours is as right as the other. A new scene is a new file. *)

open Raylab_scene
open Raylab_language
open Raylab_tracer

let levels = 3
let least = 0.985

let load file =
  match Scene_file.load file with
  | Ok loaded -> loaded
  | Error _ -> Alcotest.failf "%s is not a scene" file

(* Rows from the top, three bytes a pixel. Where domains were, no process can be
   started. *)
let ours scene =
  Picture.to_rgb (fst (Render.picture ~domains:1 (Prepared.make scene)))

(* What POV-Ray writes as PPM: a header with comments, and the same bytes. *)
let read_ppm ~size file =
  let text = In_channel.with_open_bin file In_channel.input_all in
  Bytes.of_string (String.sub text (String.length text - size) size)

let in_folder work =
  let dir = Filename.temp_dir "raylab" "povray" in
  let remove () =
    Array.iter (fun f -> Sys.remove (Filename.concat dir f)) (Sys.readdir dir);
    Sys.rmdir dir
  in
  Fun.protect ~finally:remove (fun () -> work dir)

let theirs (scene : Scene.t) =
  in_folder (fun dir ->
      let path = Filename.concat dir "scene.pov" in
      Out_channel.with_open_bin path (fun channel ->
          Povray.write channel scene);
      let { Camera.width; height; _ } = scene.camera in
      match
        Povray.render ~picture:"scene.ppm" ~threads:1 ~width ~height path
      with
      | Ok _ ->
          read_ppm ~size:(3 * width * height) (Filename.concat dir "scene.ppm")
      | Error reason -> Alcotest.failf "POV-Ray: %s" reason)

let share_near a b =
  let pixels = Bytes.length a / 3 and count = ref 0 in
  let near at = abs (Bytes.get_uint8 a at - Bytes.get_uint8 b at) <= levels in
  for k = 0 to pixels - 1 do
    if near (3 * k) && near ((3 * k) + 1) && near ((3 * k) + 2) then incr count
  done;
  float_of_int !count /. float_of_int pixels

let test file () =
  let scene = load file in
  let share = share_near (ours scene) (theirs scene) in
  if share < least then
    Alcotest.failf "only %.2f %% of the pixels are as POV-Ray's" (100. *. share)

let () =
  match Povray.version () with
  | None ->
      print_endline
        "povray is not installed, so nothing is compared: bin/setup --test \
         installs it"
  | Some _ ->
      let is_scene file = Filename.extension file = ".scene" in
      let case file =
        Alcotest.test_case
          (Filename.remove_extension file)
          `Quick
          (test (Filename.concat "scenes" file))
      in
      Sys.readdir "scenes" |> Array.to_list |> List.filter is_scene
      |> List.sort String.compare |> List.map case
      |> fun cases -> Alcotest.run "povray" [ ("as POV-Ray", cases) ]
