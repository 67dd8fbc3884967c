open Raylab_scene
open Raylab_language
open Test_support

let write path text =
  Out_channel.with_open_bin path (fun channel ->
      Out_channel.output_string channel text)

let test_file () =
  write "good.scene" (Read.with_header "sphere 0 0 6 1 reflective\r\n");
  match Scene_file.load "good.scene" with
  | Ok scene ->
      Alcotest.check Same.scene "as parsed"
        (Scene.make Read.camera
           ~objects:[ Build.sphere (Build.v 0. 0. 6.) 1. Surface.reflective ])
        scene
  | Error _ -> Alcotest.fail "a good scene is refused"

let only_error path =
  match Scene_file.load path with
  | Error [ error ] -> error
  | Error _ -> Alcotest.failf "%s: more than one error" path
  | Ok _ -> Alcotest.failf "%s: no error" path

let test_error () =
  write "bad.scene" "imWidth x";
  let { Scene_error.file; place; message; _ } = only_error "bad.scene" in
  Alcotest.(check string) "file" "bad.scene" file;
  Alcotest.(check bool) "place" true (place <> None);
  Alcotest.(check string) "message" "'x' is not a number" message

(* The reasons are the system's. In JavaScript they are Node's. *)
let test_unreadable () =
  let check path reason =
    let error = only_error path in
    Alcotest.(check string) "file" path error.file;
    Alcotest.(check bool) "no place" true (error.place = None);
    if not Javascript.here then
      Alcotest.(check string) "reason" reason error.message;
    Alcotest.(check string)
      "printed"
      (Printf.sprintf "%s: error: %s" path error.message)
      (Property.show Scene_error.pp error)
  in
  check "missing.scene" "No such file or directory";
  check "no/such/folder.scene" "No such file or directory";
  check "." "Is a directory"

(* A file whose size is not known before is read to its end. *)
let test_device () =
  let { Scene_error.message; _ } = only_error "/dev/null" in
  Expect.contains "an empty scene" ~part:"the header lacks" message

let test_name () =
  Alcotest.(check string)
    "printable" "no\u{FFFD}file" (only_error "no\nfile").file

let test_without_extension () =
  let check path expected =
    Alcotest.(check string) path expected (Scene_file.without_extension path)
  in
  check "a.scene" "a";
  check "folder.txt/a.TXT" "folder.txt/a";
  check "a.scene.txt" "a.scene";
  check "run_0.05" "run_0.05";
  check "run_0.05.scene" "run_0.05";
  check "a.scene~" "a.scene~";
  check ".scene" ".scene";
  check "folder.scene/a" "folder.scene/a"

let suite =
  ( "Load",
    [
      Alcotest.test_case "a file" `Quick test_file;
      Alcotest.test_case "a file in error" `Quick test_error;
      Alcotest.test_case "unreadable" `Quick test_unreadable;
      Alcotest.test_case "a device" `Quick test_device;
      Alcotest.test_case "name" `Quick test_name;
      Alcotest.test_case "extension" `Quick test_without_extension;
    ] )
