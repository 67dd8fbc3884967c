open Raylab_picture
open Test_support

let show = function
  | Ok Picture_file.Bmp -> "BMP"
  | Ok Png -> "PNG"
  | Ok Ppm -> "PPM"
  | Error _ -> "none"

let test_path () =
  let check path expected =
    Alcotest.(check string)
      path expected
      (show (Picture_file.format_of_path path))
  in
  check "a.bmp" "BMP";
  check "a.png" "PNG";
  check "a.ppm" "PPM";
  check "A.PNG" "PNG";
  check "a.Ppm" "PPM";
  check "a" "BMP";
  check "some.folder/a" "BMP";
  check "a.png.bmp" "BMP";
  check "../a.scene.png" "PNG";
  check "a.jpg" "none";
  check "a.png~" "none";
  check "a.bmp.scene" "none";
  check ".png" "none";
  check "some.folder/.png" "none";
  check "..png" "none";
  check ".hidden.png" "PNG";
  check "." "BMP";
  check "some.folder/.." "BMP"

let test_message () =
  match Picture_file.format_of_path "dir/a.jpg" with
  | Ok _ -> Alcotest.fail "no such format"
  | Error message ->
      List.iter
        (fun part -> Expect.contains "message" ~part message)
        [ "dir/a.jpg"; ".bmp"; ".png"; ".ppm" ]

let fits format ~width ~height =
  Result.is_ok (Picture_file.check_size format ~width ~height)

(* 4 GiB of 3 bytes a pixel are 1431655765 pixels and one byte. *)
let test_size () =
  let check what expected actual =
    Alcotest.(check bool) what expected actual
  in
  List.iter
    (fun format ->
      check "everyday" true (fits format ~width:1920 ~height:1080);
      check "1 x 1" true (fits format ~width:1 ~height:1);
      check "both the largest" false
        (fits format ~width:0x7fffffff ~height:0x7fffffff))
    Sample.formats;
  check "just fits" true (fits Ppm ~width:1431655765 ~height:1);
  check "just does not" false (fits Ppm ~width:1431655766 ~height:1);
  (* a row of BMP has as many bytes as its pixels, filled up to 4 *)
  check "BMP of 4 GiB" false (fits Bmp ~width:1431655765 ~height:1);
  check "BMP below" true (fits Bmp ~width:1431655500 ~height:1);
  check "filled up" false (fits Bmp ~width:1 ~height:0x40000000);
  check "not filled up" true (fits Ppm ~width:1 ~height:0x40000000);
  check "a wide PNG" true (fits Png ~width:1431655765 ~height:1);
  check "a high PNG" true (fits Png ~width:1 ~height:1431655765)

let suite =
  ( "Formats",
    [
      Alcotest.test_case "of a path" `Quick test_path;
      Alcotest.test_case "message" `Quick test_message;
      Alcotest.test_case "size" `Quick test_size;
    ] )
