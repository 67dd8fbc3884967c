(* What is saved is read back, pixel for pixel: BMP and PPM by hand, PNG by the
   reader of bands. Other programs read it in other_readers.t. *)

open Raylab_tracer
open Raylab_picture

type image = {
  width : int;
  height : int;
  pixel : int -> int -> int * int * int;
}

let load_bmp path =
  let text = Sample.read path in
  let length = String.length text in
  let number at = Int32.to_int (String.get_int32_le text at) in
  let width = number 18 and height = number 22 in
  let stride = (length - 54) / height in
  let check what expected at =
    Alcotest.(check int) what expected (number at)
  in
  Alcotest.(check string) "what it is" "BM" (String.sub text 0 2);
  check "length" length 2;
  check "nothing" 0 6;
  check "where the pixels start" 54 10;
  check "information header" 40 14;
  check "planes, and bits a pixel" ((24 lsl 16) + 1) 26;
  check "no compression" 0 30;
  check "bytes of pixels" (stride * height) 34;
  check "no palette" 0 46;
  check "no colours that matter" 0 50;
  Alcotest.(check int) "rows are filled up" 0 (stride mod 4);
  let pixel x y =
    let k = 54 + (stride * (height - 1 - y)) + (3 * x) in
    let byte i = Char.code text.[k + i] in
    (byte 2, byte 1, byte 0)
  in
  { width; height; pixel }

(* After lines of comment and three numbers come a line end and the bytes. *)
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

let load_png ~width ~height path =
  match
    In_channel.with_open_bin path (fun channel ->
        Png_file.read channel ~width ~height)
  with
  | None -> Alcotest.failf "%s is no PNG of this size" path
  | Some rgb ->
      let pixel x y =
        let byte i = Bytes.get_uint8 rgb ((3 * ((y * width) + x)) + i) in
        (byte 0, byte 1, byte 2)
      in
      { width; height; pixel }

let load format path ~width ~height =
  match (format : Picture_file.format) with
  | Bmp -> load_bmp path
  | Png -> load_png path ~width ~height
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
        (Result.map ignore (Picture_file.save format ~path picture));
      check_same path picture (load format path ~width ~height))
    sizes

(* {1 Pieces}

   The file is the same in whatever pieces the rows come. *)

let in_pieces count picture =
  let width = Picture.width picture and height = Picture.height picture in
  let rows = Rows.of_bytes ~width ~top:0 (Picture.to_rgb picture) in
  let rec firsts y = if y < height then y :: firsts (y + count) else [] in
  let iter ~lowest_first f =
    let firsts = firsts 0 in
    List.iter
      (fun first ->
        let rgb = rows ~first ~count:(Int.min count (height - first)) in
        f rgb 0 (Bytes.length rgb))
      (if lowest_first then List.rev firsts else firsts)
  in
  { (Pixels.of_picture picture) with iter }

let test_pieces format folder =
  let path = Filename.concat folder "a" in
  let saved result =
    Alcotest.(check (result unit string))
      "saved" (Ok ()) (Result.map ignore result);
    Sample.read path
  in
  let picture = Sample.picture ~width:63 ~height:65 in
  let whole = saved (Picture_file.save format ~path picture) in
  List.iter
    (fun count ->
      let pixels = in_pieces count picture in
      Alcotest.(check bool)
        (Printf.sprintf "%d at once" count)
        true
        (whole = saved (Picture_file.save_pixels format ~path pixels)))
    [ 1; 2; 33; 64; 65 ]

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
      test "pieces of BMP" (test_pieces Bmp);
      test "pieces of PNG" (test_pieces Png);
      test "pieces of PPM" (test_pieces Ppm);
      test "PNG signature" (starts_with "\x89PNG\r\n\x1a\n" Png);
      test "PPM signature" (starts_with "P6" Ppm);
      test "PPM bytes" test_ppm_bytes;
    ] )
