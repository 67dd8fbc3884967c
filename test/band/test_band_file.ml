open Raylab_tracer
open Raylab_band
open Test_support

let width = 5
let height = 9
let picture = Sample.picture ~width ~height
let band = Band.make (Sample.whole ~width ~height) ~first:2 ~last:6

let with_band format f folder =
  let path = Filename.concat folder "band" in
  Sample.save format path picture ~first:2 ~last:6;
  f path

let test_read format =
  with_band format (fun path ->
      match Band_file.check path with
      | Error message -> Alcotest.fail message
      | Ok file ->
          Alcotest.(check string) "path" path (Band_file.path file);
          Alcotest.(check bool) "band" true (Band_file.band file = band);
          let two = Sample.rows picture ~first:3 ~last:4 in
          Alcotest.(check bytes)
            "rows 3 and 4" (Picture.to_rgb two)
            (Band_file.with_rows file (fun rows -> rows ~first:3 ~count:2)))

let test_size folder =
  Expect.invalid "size" (fun () ->
      Band_writer.save Ppm ~path:(Filename.concat folder "a") band picture)

let test_changed format =
  with_band format (fun path ->
      match Band_file.check path with
      | Error message -> Alcotest.fail message
      | Ok file -> (
          Sample.write path "short";
          match
            Band_file.with_rows file (fun rows -> rows ~first:2 ~count:5)
          with
          | exception Band_file.Unreadable message ->
              Expect.contains "its name" ~part:path message
          | _ -> Alcotest.fail "read"))

let suite =
  ( "Files",
    Sample.for_each "read back" test_read
    @ Sample.for_each "changed since" test_changed
    @ [ Sample.test "another size" test_size ] )
