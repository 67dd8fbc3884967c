(* Where nothing can be written: an error that names the path, nothing left
   behind, nothing touched. All of this fails for root as well. *)

open Raylab_picture
open Test_support

let picture = Sample.picture ~width:5 ~height:3

let check_fails what reason path =
  List.iter
    (fun format ->
      match Picture_file.save format ~path picture with
      | Ok _ -> Alcotest.failf "%s: no error" what
      | Error message ->
          Expect.contains what ~part:path message;
          Expect.contains what ~part:reason (String.lowercase_ascii message);
          Alcotest.(check (list string))
            "no file in use" [] (Atomic_file.temporary ()))
    Sample.formats

let test_directory folder =
  let path = Filename.concat folder "a.bmp" in
  Unix.mkdir path 0o755;
  check_fails "a directory" "is a directory" path;
  Alcotest.(check (list string)) "only it" [ "a.bmp" ] (Sample.files folder);
  Alcotest.(check (list string)) "and empty" [] (Sample.files path)

let test_missing_directory folder =
  check_fails "no directory" "no such file or directory"
    (Filename.concat folder "not/there/a.bmp");
  Alcotest.(check (list string)) "nothing" [] (Sample.files folder)

let test_file_as_directory folder =
  let file = Filename.concat folder "file" in
  Sample.write file "old";
  check_fails "a file in its place" "not a directory"
    (Filename.concat file "a.bmp");
  Alcotest.(check (list string)) "only it" [ "file" ] (Sample.files folder);
  Alcotest.(check string) "untouched" "old" (Sample.read file)

let test_slash folder =
  check_fails "a name that ends as a directory's" ""
    (Filename.concat folder "a.bmp/");
  Alcotest.(check (list string)) "nothing" [] (Sample.files folder)

let test_long_name folder =
  check_fails "a name too long" "too long"
    (Filename.concat folder (String.make 300 'a' ^ ".bmp"));
  Alcotest.(check (list string)) "nothing" [] (Sample.files folder)

let test_link_to_itself folder =
  let link = Filename.concat folder "a.bmp" in
  Unix.symlink "a.bmp" link;
  check_fails "a link to itself" "symbolic links" link;
  Alcotest.(check (list string)) "only it" [ "a.bmp" ] (Sample.files folder)

let test_full _ = check_fails "a full device" "no space left" "/dev/full"
let test name f = Alcotest.test_case name `Quick (Sample.in_new_folder f)

let suite =
  ( "Failures",
    [
      test "a directory" test_directory;
      test "a missing directory" test_missing_directory;
      test "a file for a directory" test_file_as_directory;
      test "a slash at the end" test_slash;
      test "a name too long" test_long_name;
      test "a link to itself" test_link_to_itself;
      test "a full device" test_full;
    ] )
