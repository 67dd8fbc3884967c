(* What is written piece by piece is what the library of picture files
   writes. *)

open Raylab_tracer
open Raylab_picture
open Raylab_band

let write format picture path =
  let width = Picture.width picture and height = Picture.height picture in
  Uncompressed.write format ~label:"" ~width ~height
    (fun ~lowest_first emit ->
      (* two pieces, if there are two rows *)
      let half = height / 2 in
      let rows = Rows.of_bytes ~width ~top:0 (Picture.to_rgb picture) in
      let upper () = if half > 0 then emit (rows ~first:0 ~count:half)
      and lower () = emit (rows ~first:half ~count:(height - half)) in
      if lowest_first then (
        lower ();
        upper ())
      else (
        upper ();
        lower ()))
    path

let sizes =
  [ (1, 1); (2, 1); (1, 2); (3, 5); (5, 3); (4, 4); (7, 2); (63, 65) ]

let test_same format other folder =
  List.iter
    (fun (width, height) ->
      let picture = Sample.picture ~width ~height in
      let ours = Filename.concat folder "ours"
      and theirs = Filename.concat folder "theirs" in
      write format picture ours;
      Picture_file.write other picture theirs;
      Alcotest.(check string)
        (Printf.sprintf "%dx%d" width height)
        (Sample.read theirs) (Sample.read ours))
    sizes

(* Two rows of one pixel each, worked out by hand. *)
let test_bmp_rows () =
  let rgb = Bytes.of_string "rgbRGB" in
  let bmp = Bytes.of_string "BGR\000bgr\000" in
  Alcotest.(check bytes) "encoded" bmp (Uncompressed.encode Bmp ~width:1 rgb);
  Alcotest.(check bytes) "decoded" rgb (Uncompressed.decode Bmp ~width:1 bmp);
  Alcotest.(check int) "stride" 4 (Uncompressed.stride Bmp ~width:1)

let test_labels () =
  let check format =
    let header = Uncompressed.header format ~label:"a b" ~width:3 ~height:2 in
    Alcotest.(check (option string))
      "found" (Some "a b")
      (Uncompressed.label format header);
    let short = String.sub header 0 (String.length header / 2) in
    ignore (Uncompressed.label format short);
    Alcotest.(check (option string))
      "not in nothing" None
      (Uncompressed.label format "")
  in
  check Bmp;
  check Ppm;
  Alcotest.(check (option string))
    "no end" None
    (Uncompressed.label Ppm "P6\n# a b");
  Alcotest.(check (option string))
    "another format" None
    (Uncompressed.label Bmp "P6\n# a b\n")

let suite =
  ( "Uncompressed",
    [
      Sample.test "BMP" (test_same Bmp Bmp);
      Sample.test "PPM" (test_same Ppm Ppm);
      Alcotest.test_case "rows of a BMP" `Quick test_bmp_rows;
      Alcotest.test_case "labels" `Quick test_labels;
    ] )
