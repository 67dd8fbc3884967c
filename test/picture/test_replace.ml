(* What becomes of the file that was there before. *)

open Raylab_picture

let picture = Sample.picture ~width:5 ~height:3

let save path =
  match Picture_file.save Ppm ~path picture with
  | Ok _ -> ()
  | Error message -> Alcotest.fail message

(* The bytes that a saved picture has. *)
let expected =
  lazy
    (let path = Filename.temp_file "raylab-test-" ".ppm" in
     save path;
     let bytes = Sample.read path in
     Sys.remove path;
     bytes)

let check_is_picture path =
  Alcotest.(check string) path (Lazy.force expected) (Sample.read path)

let permissions path = (Unix.stat path).st_perm

let test_new folder =
  let path = Filename.concat folder "a.ppm" in
  save path;
  check_is_picture path;
  Alcotest.(check (list string))
    "no other file" [ "a.ppm" ] (Sample.files folder);
  Alcotest.(check (list string)) "none in use" [] (Atomic_file.temporary ());
  let mask = Unix.umask 0 in
  ignore (Unix.umask mask);
  Alcotest.(check int)
    "as other new files"
    (0o666 land lnot mask)
    (permissions path)

let test_replaced folder =
  let path = Filename.concat folder "a.ppm" in
  Sample.write path (String.make 10_000 'x');
  List.iter
    (fun mode ->
      Unix.chmod path mode;
      save path;
      check_is_picture path;
      Alcotest.(check int) "its permissions are kept" mode (permissions path))
    [ 0o600; 0o644; 0o755; 0o666 ];
  Alcotest.(check (list string))
    "no other file" [ "a.ppm" ] (Sample.files folder)

let test_symlink folder =
  let folder_of name = Filename.concat folder name in
  Unix.mkdir (folder_of "there") 0o755;
  let target = folder_of "there/a.ppm" and link = folder_of "link.ppm" in
  Sample.write target "old";
  Unix.symlink "there/a.ppm" link;
  save link;
  check_is_picture target;
  Alcotest.(check string) "still a link" "there/a.ppm" (Unix.readlink link);
  Alcotest.(check (list string))
    "no other file here" [ "link.ppm"; "there" ] (Sample.files folder);
  Alcotest.(check (list string))
    "nor there" [ "a.ppm" ]
    (Sample.files (folder_of "there"))

(* A link to a file that is not there yet is followed too. *)
let test_dangling_symlink folder =
  let link = Filename.concat folder "link.ppm" in
  Unix.symlink "a.ppm" link;
  save link;
  Alcotest.(check bool) "still a link" true ((Unix.lstat link).st_kind = S_LNK);
  check_is_picture (Filename.concat folder "a.ppm")

(* Another name of the same file keeps the old picture: the new one is another
   file that takes the name's place. *)
let test_hard_link folder =
  let path = Filename.concat folder "a.ppm"
  and other = Filename.concat folder "b.ppm" in
  Sample.write path "old";
  Unix.link path other;
  save path;
  check_is_picture path;
  Alcotest.(check string) "whole or not at all" "old" (Sample.read other)

let test_device _ = save "/dev/null"

let test_relative folder =
  let here = Sys.getcwd () in
  Fun.protect
    ~finally:(fun () -> Sys.chdir here)
    (fun () ->
      Sys.chdir folder;
      save "a.ppm";
      check_is_picture "a.ppm";
      Alcotest.(check (list string)) "alone" [ "a.ppm" ] (Sample.files "."))

let test name f = Alcotest.test_case name `Quick (Sample.in_new_folder f)

let suite =
  ( "Replacing",
    [
      test "a new file" test_new;
      test "an older file" test_replaced;
      test "a symbolic link" test_symlink;
      test "a symbolic link to nothing" test_dangling_symlink;
      test "a hard link" test_hard_link;
      test "a device" test_device;
      test "a relative path" test_relative;
    ] )
