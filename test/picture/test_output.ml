(* Pictures to a channel, as for standard output. *)

open Raylab_picture
open Test_support

let picture = Sample.picture ~width:50 ~height:30

let test_same_bytes folder =
  List.iter
    (fun format ->
      let saved = Filename.concat folder "saved"
      and written = Filename.concat folder "written" in
      ignore (Picture_file.save format ~path:saved picture);
      Out_channel.with_open_bin written (fun channel ->
          Alcotest.(check (result unit string))
            "written" (Ok ())
            (Picture_file.output format channel picture);
          (* it is flushed: all is there before the channel is closed *)
          Alcotest.(check bool)
            "as in a file" true
            (Sample.read saved = Sample.read written)))
    Sample.formats;
  Alcotest.(check (list string)) "none in use" [] (Atomic_file.temporary ())

let test_full _ =
  List.iter
    (fun format ->
      let channel = Out_channel.open_bin "/dev/full" in
      (match Picture_file.output format channel picture with
      | Ok () -> Alcotest.fail "no error"
      | Error message -> Expect.contains "full" ~part:"No space left" message);
      Out_channel.close_noerr channel)
    Sample.formats;
  Alcotest.(check (list string)) "none in use" [] (Atomic_file.temporary ())

let test_no_folder _ =
  let folder = Filename.get_temp_dir_name () in
  let channel = Out_channel.open_bin "/dev/null" in
  Filename.set_temp_dir_name "/missing";
  Fun.protect
    ~finally:(fun () -> Filename.set_temp_dir_name folder)
    (fun () ->
      List.iter
        (fun format ->
          Alcotest.(check (result unit string))
            "written" (Ok ())
            (Picture_file.output format channel picture))
        Sample.formats);
  Out_channel.close channel

let test name f = Alcotest.test_case name `Quick (Sample.in_new_folder f)

let suite =
  ( "Output",
    [
      test "the bytes of a file" test_same_bytes;
      test "a full device" test_full;
      test "without a folder for temporary files" test_no_folder;
    ] )
