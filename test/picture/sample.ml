open Raylab_scene
open Raylab_tracer

(* 7, 11 and 13 have no common factor with 256. *)
let picture ~width ~height =
  let picture = Picture.create ~width ~height in
  let level k = float_of_int (k land 255) /. 255. in
  for y = 0 to height - 1 do
    for x = 0 to width - 1 do
      let k = (y * width) + x in
      Picture.set picture ~x ~y
        (Color.make
           (level ((7 * k) + 1))
           (level ((11 * k) + 2))
           (level ((13 * k) + (k / 256) + 3)))
    done
  done;
  picture

let files folder = List.sort compare (Array.to_list (Sys.readdir folder))

let rec remove path =
  match (Unix.lstat path).st_kind with
  | S_DIR ->
      List.iter (fun name -> remove (Filename.concat path name)) (files path);
      Unix.rmdir path
  | _ -> Sys.remove path

let in_new_folder f () =
  let folder = Filename.temp_dir "raylab-test-" "" in
  Fun.protect ~finally:(fun () -> remove folder) (fun () -> f folder)

let read path = In_channel.with_open_bin path In_channel.input_all

let write path text =
  Out_channel.with_open_bin path (fun channel ->
      Out_channel.output_string channel text)

let formats = List.map snd Raylab_picture.Picture_file.formats
