(* What is saved is read back by another program, pixel for pixel. *)

open Raylab_tracer
open Raylab_picture

type image = {
  width : int;
  height : int;
  pixel : int -> int -> int * int * int;
}

let of_camlimages = function
  | Images.Rgb24 image ->
      let pixel x y =
        let { Color.r; g; b } = Rgb24.get image x y in
        (r, g, b)
      in
      { width = image.width; height = image.height; pixel }
  | _ -> Alcotest.fail "not a picture of 24 bits a pixel"

(* By hand: camlimages takes no PPM whose width or height has one digit. After
   lines of comment and three numbers come a line end and the bytes. *)
let load_ppm path =
  let text = Sample.read path in
  let rec data_at lines at =
    let stop = String.index_from text at '\n' in
    let line = String.sub text at (stop - at) in
    if String.starts_with ~prefix:"#" line then data_at lines (stop + 1)
    else if List.length lines = 2 then (List.rev (line :: lines), stop + 1)
    else data_at (line :: lines) (stop + 1)
  in
  match data_at [] 0 with
  | [ "P6"; size; "255" ], start ->
      let width, height = Scanf.sscanf size "%d %d" (fun w h -> (w, h)) in
      let byte k = Char.code text.[start + k] in
      let pixel x y =
        let k = 3 * ((y * width) + x) in
        (byte k, byte (k + 1), byte (k + 2))
      in
      Alcotest.(check int)
        "bytes"
        (3 * width * height)
        (String.length text - start);
      { width; height; pixel }
  | _ -> Alcotest.failf "%s is no PPM" path

let load format path =
  match (format : Picture_file.format) with
  | Bmp -> of_camlimages (Bmp.load path [])
  | Png -> of_camlimages (Png.load path [])
  | Ppm -> load_ppm path

let check_same what picture image =
  let width = Picture.width picture and height = Picture.height picture in
  Alcotest.(check (pair int int))
    what (width, height)
    (image.width, image.height);
  for y = 0 to height - 1 do
    for x = 0 to width - 1 do
      Alcotest.check Test_support.Same.levels what
        (Picture.get picture ~x ~y)
        (image.pixel x y)
    done
  done

let sizes =
  [ (1, 1); (2, 1); (1, 2); (3, 5); (5, 3); (4, 4); (7, 2); (63, 65) ]

let test_format format folder =
  List.iter
    (fun (width, height) ->
      let picture = Sample.picture ~width ~height in
      let path =
        Filename.concat folder (Printf.sprintf "%dx%d" width height)
      in
      Alcotest.(check (result unit string))
        "saved" (Ok ())
        (Picture_file.save format ~path picture);
      check_same path picture (load format path))
    sizes

let starts_with prefix format folder =
  let path = Filename.concat folder "a" in
  ignore (Picture_file.save format ~path (Sample.picture ~width:3 ~height:2));
  Alcotest.(check bool)
    "its format" true
    (String.starts_with ~prefix (Sample.read path))

(* A PPM by hand: its header, then the bytes of the two pixels. *)
let test_ppm_bytes folder =
  let path = Filename.concat folder "a.ppm" in
  ignore (Picture_file.save Ppm ~path (Sample.picture ~width:2 ~height:1));
  let bytes = Sample.read path in
  let n = String.length bytes in
  Alcotest.(check string)
    "the last bytes" "\001\002\003\008\013\016"
    (String.sub bytes (n - 6) 6)

let test name f = Alcotest.test_case name `Quick (Sample.in_new_folder f)

let suite =
  ( "Pixels",
    [
      test "BMP" (test_format Bmp);
      test "PNG" (test_format Png);
      test "PPM" (test_format Ppm);
      test "BMP signature" (starts_with "BM" Bmp);
      test "PNG signature" (starts_with "\x89PNG\r\n\x1a\n" Png);
      test "PPM signature" (starts_with "P6" Ppm);
      test "PPM bytes" test_ppm_bytes;
    ] )
