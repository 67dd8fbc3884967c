open Raylab_tracer
open Raylab_picture
open Raylab_band

let whole ~width ~height =
  let scene = Digest.string "a" in
  let film = Raylab_scene.Film.default in
  { Band.width; height; grey = false; film; scene; version = "0.1.0" }

(* 7, 11 and 13 have no common factor with 256. *)
let picture ~width ~height =
  let picture = Picture.create ~width ~height in
  let rgb = Picture.to_rgb picture in
  Bytes.iteri
    (fun k _ ->
      let factor = [| 7; 11; 13 |].(k mod 3) in
      Bytes.set_uint8 rgb k (((factor * (k / 3)) + k) land 255))
    rgb;
  picture

let rows picture ~first ~last =
  let width = Picture.width picture in
  let band = Picture.create ~width ~height:(last - first + 1) in
  let to_ = Picture.to_rgb band in
  Bytes.blit (Picture.to_rgb picture)
    (3 * width * first)
    to_ 0 (Bytes.length to_);
  band

let save ?whole:known format path picture ~first ~last =
  let default =
    whole ~width:(Picture.width picture) ~height:(Picture.height picture)
  in
  let whole = Option.value ~default known in
  match
    Band_writer.save format ~path
      (Band.make whole ~first ~last)
      (rows picture ~first ~last)
  with
  | Ok _ -> ()
  | Error message -> Alcotest.fail message

let in_new_folder f () =
  let folder = Filename.temp_dir "raylab-test-" "" in
  let remove () =
    Array.iter
      (fun name -> Sys.remove (Filename.concat folder name))
      (Sys.readdir folder);
    Unix.rmdir folder
  in
  Fun.protect ~finally:remove (fun () -> f folder)

let read path = In_channel.with_open_bin path In_channel.input_all

let write path text =
  Out_channel.with_open_bin path (fun channel ->
      Out_channel.output_string channel text)

let formats = List.map snd Picture_file.formats
let test name f = Alcotest.test_case name `Quick (in_new_folder f)

let for_each name f =
  List.map
    (fun (extension, format) -> test (name ^ " " ^ extension) (f format))
    Picture_file.formats
