open Raylab_slurm

let job =
  {
    Job.raylab = "raylab";
    view = [];
    height = 4;
    bands = 2;
    cores = 1;
    out = "/x.ppm";
  }

let read path = In_channel.with_open_bin path In_channel.input_all

(* All files of a scene are copied, and any of them may be another. *)
let test_files () =
  let folder = Filename.concat (Filename.temp_dir "slurm" "") "job" in
  let write wood =
    Folder.write folder job
      ~files:[ (Job.scene, "a scene"); ("parts/woods/oak.scene", wood) ]
  in
  let inside = Filename.concat folder in
  Alcotest.(check (result unit string)) "written" (Ok ()) (write "oak");
  Alcotest.(check string) "the scene" "a scene" (read (inside Job.scene));
  Alcotest.(check string)
    "the other file" "oak"
    (read (inside "parts/woods/oak.scene"));
  Alcotest.(check (result unit string)) "the same again" (Ok ()) (write "oak");
  Alcotest.(check bool) "another" true (Result.is_error (write "another oak"));
  Alcotest.(check string)
    "it is left alone" "oak"
    (read (inside "parts/woods/oak.scene"))

let () =
  Alcotest.run "raylab.slurm"
    [ ("Folder", [ Alcotest.test_case "files" `Quick test_files ]) ]
