(* Whatever is done to the file of a band, it is refused, with its name, or
   makes no difference to the picture. *)

open Raylab_tracer
open Raylab_picture
open Raylab_band
open Test_support

let width = 5
let height = 6
let picture = Sample.picture ~width ~height

let rows file =
  Band_file.with_rows file (fun rows -> rows ~first:0 ~count:height)

let is_refused_or_same path =
  match Band_file.check path with
  | Error message ->
      Expect.contains "its name" ~part:path message;
      true
  | Ok file ->
      Band_file.band file
      = Band.make (Sample.whole ~width ~height) ~first:0 ~last:(height - 1)
      && Bytes.equal (rows file) (Picture.to_rgb picture)

(* [damaging format f] is [f text try], where [text] is the bytes of a band, and
   [try] checks others in their place. *)
let damaging format f folder =
  let path = Filename.concat folder "band" in
  Sample.save format path picture ~first:0 ~last:(height - 1);
  f (Sample.read path) (fun what bytes ->
      Sample.write path bytes;
      Alcotest.(check bool) what true (is_refused_or_same path))

let test_flips format =
  damaging format (fun text try_ ->
      String.iteri
        (fun k c ->
          List.iter
            (fun mask ->
              let bytes = Bytes.of_string text in
              Bytes.set_uint8 bytes k (Char.code c lxor mask);
              try_ (Printf.sprintf "byte %d" k) (Bytes.to_string bytes))
            [ 1; 0x20; 0x80; 0xff ])
        text)

let is_refused path =
  match Band_file.check path with Ok _ -> false | Error _ -> true

let test_cut format folder =
  let path = Filename.concat folder "band" in
  Sample.save format path picture ~first:0 ~last:(height - 1);
  let text = Sample.read path in
  for length = 0 to String.length text - 1 do
    Sample.write path (String.sub text 0 length);
    Alcotest.(check bool) (string_of_int length) true (is_refused path)
  done;
  Sample.write path (text ^ "\000");
  Alcotest.(check bool) "too long" true (is_refused path)

(* Labels that are right of files that are not: sizes that would not fit into
   memory, and PNGs whose parts are whole but hold no picture. *)
let label ~width ~height =
  Band.label
    (Band.make (Sample.whole ~width ~height) ~first:0 ~last:(height - 1))
    Crc32.empty

let chunk name data =
  let text = Bytes.make (String.length data + 12) '\000' in
  let set = Bytes.set_int32_be text in
  set 0 (Int32.of_int (String.length data));
  Bytes.blit_string (name ^ data) 0 text 4 (4 + String.length data);
  let crc = (Crc32.add Crc32.empty (name ^ data) :> int) in
  set (String.length data + 8) (Int32.of_int crc);
  Bytes.to_string text

(* A PNG whose parts are right, with these packed pixels. *)
let png ~label ~width ~height data =
  Png_chunk.signature
  ^ chunk "IHDR" (Png_chunk.header ~width ~height)
  ^ chunk "tEXt" (Png_chunk.text label)
  ^ chunk "IDAT" data ^ chunk "IEND" ""

let huge = 0x7fffffff

let test_large folder =
  let path = Filename.concat folder "band" in
  List.iter
    (fun (width, height) ->
      let label = label ~width ~height in
      let check file =
        Sample.write path file;
        Alcotest.(check bool) "refused" true (is_refused path)
      in
      List.iter
        (fun format ->
          check
            (let label = Some label in
             Uncompressed.header format ~label ~width ~height
             ^ "\000\000\000"
             ^ Uncompressed.trailer format ~label))
        [ Uncompressed.Bmp; Ppm ];
      check (png ~label ~width ~height "\x78\x9c\x03\x00\x00\x00\x00\x01"))
    [ (huge, huge); (huge, 1); (1, huge); (30000, 30000) ]

let test_empty_png folder =
  let path = Filename.concat folder "band" in
  let label = label ~width ~height in
  List.iter
    (fun data ->
      Sample.write path (png ~label ~width ~height data);
      Alcotest.(check bool) "refused" true (is_refused path))
    [ ""; "no deflate"; "\x78\x9c\x03\x00\x00\x00\x00\x01" ]

(* Every byte of the packed pixels changed, in a chunk that is right. *)
let test_packed folder =
  let path = Filename.concat folder "band" in
  Sample.save Png path picture ~first:0 ~last:(height - 1);
  let png = Sample.read path in
  let length at = Int32.to_int (String.get_int32_be png at) in
  let idat = 33 + 12 + length 33 in
  let before = String.sub png 0 idat
  and packed = String.sub png (idat + 8) (length idat) in
  Alcotest.(check string) "there" "IDAT" (String.sub png (idat + 4) 4);
  String.iteri
    (fun k c ->
      List.iter
        (fun mask ->
          let data = Bytes.of_string packed in
          Bytes.set_uint8 data k (Char.code c lxor mask);
          Sample.write path
            (before ^ chunk "IDAT" (Bytes.to_string data) ^ chunk "IEND" "");
          Alcotest.(check bool)
            (string_of_int k) true (is_refused_or_same path))
        [ 1; 0x10; 0xff ])
    packed

let is_told text =
  let told = ref false in
  Sample.in_new_folder
    (fun folder ->
      let path = Filename.concat folder "band" in
      Sample.write path text;
      told := is_refused path)
    ();
  !told

let any_start =
  QCheck2.Gen.(
    map2 ( ^ )
      (oneofl
         [
           "P6\n# raylab-band 1 ";
           "BM" ^ String.make 52 '\001' ^ "\nraylab-band 1 ";
           "\x89PNG\r\n\x1a\n";
           "";
         ])
      (string_size (int_bound 600)))

let suite =
  ( "Damage",
    Sample.for_each "any byte" test_flips
    @ Sample.for_each "any length" test_cut
    @ [
        Sample.test "large sizes" test_large;
        Sample.test "no picture in a PNG" test_empty_png;
        Sample.test "other pixels in a PNG" test_packed;
        Property.holds "any bytes" any_start is_told;
      ] )
