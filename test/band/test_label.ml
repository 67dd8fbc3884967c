open Raylab_scene
open Raylab_picture
open Raylab_band
open Test_support

let whole = Sample.whole ~width:60 ~height:40

let text =
  "raylab-band 2 rows 10-19 of 60x40 rgb samples 1 exposure 1 linear scene \
   0cc175b9c0f1b6a831c399e269772661 raylab 0.1.0 crc32 cbf43926"

let crc = Crc32.add Crc32.empty "123456789"

let test_example () =
  let band = Band.make whole ~first:10 ~last:19 in
  Alcotest.(check string) "printed" text (Band.label band crc);
  Alcotest.(check bool)
    "read" true
    (Band.of_label text = Some (band, "cbf43926"))

(* The checksum is of the label's beginning, and of the pixels. *)
let test_checksum () =
  let band = Band.make whole ~first:10 ~last:19 in
  let n = String.length " crc32 cbf43926" in
  let start = String.sub text 0 (String.length text - n) in
  Alcotest.(check string)
    "without pixels"
    Crc32.(to_hex (add empty start))
    (Crc32.to_hex (Band.checksum band))

(* [changed a b] is the label with [b] for [a]. *)
let changed a b =
  let n = String.length a in
  let rec at i = if String.sub text i n = a then i else at (i + 1) in
  let i = at 0 in
  String.sub text 0 i ^ b ^ String.sub text (i + n) (String.length text - i - n)

let test_no_label () =
  let refused what text =
    Alcotest.(check bool) what true (Band.of_label text = None)
  in
  refused "empty" "";
  refused "a later version" (changed "band 2" "band 3");
  refused "no samples" (changed "samples 1" "samples 0");
  refused "no light" (changed "exposure 1" "exposure 0");
  refused "no number" (changed "exposure 1" "exposure nan");
  refused "another encoding" (changed "linear" "gamma");
  refused "more" (text ^ " ");
  refused "cut" (String.sub text 0 (String.length text - 1));
  refused "blanks" (changed "rows 10" "rows  10");
  refused "zeros" (changed "10-19" "010-19");
  refused "a sign" (changed "10-19" "+10-19");
  refused "another base" (changed "10-19" "0xa-19");
  refused "no rows" (changed "10-19" "20-19");
  refused "beyond the picture" (changed "10-19" "10-40");
  refused "before the picture" (changed "10-19" "-1-19");
  refused "no pixels" (changed "60x40" "0x40");
  refused "too wide" (changed "60x40" "2147483648x40");
  refused "beyond integers" (changed "60x40" "60x99999999999999999999");
  refused "no colour" (changed "rgb" "rgba");
  refused "a short digest" (changed "0cc1" "0cc");
  refused "capitals" (changed "cbf4" "CBF4");
  refused "no version" (changed "0.1.0" "");
  refused "control characters" (changed "0.1.0" "\027[31m");
  refused "a long version" (changed "0.1.0" (String.make 33 '1'))

let test_make () =
  let invalid what whole first last =
    Expect.invalid what (fun () -> Band.make whole ~first ~last)
  in
  invalid "rows" whole 3 2;
  invalid "above" whole (-1) 2;
  invalid "below" whole 39 40;
  invalid "version" { whole with version = "a b" } 0 1;
  invalid "width" { whole with width = 0 } 0 1;
  Alcotest.(check int)
    "rows" 3
    (Band.rows (Band.make whole ~first:37 ~last:39))

let test_difference () =
  let check what expected other =
    Alcotest.(check (option string))
      what expected
      (Band.difference whole other)
  in
  check "none" None whole;
  check "size" (Some "the sizes differ, 60x40 and 60x30")
    { whole with height = 30 };
  check "scene" (Some "the scenes differ")
    { whole with scene = Digest.string "b" };
  check "colour" (Some "one is grey") { whole with grey = true };
  let film = whole.film in
  check "samples" (Some "the samples differ, 1 and 16")
    { whole with film = Film.with_samples 16 film };
  check "exposure" (Some "the exposures differ, 1 and 0.1")
    { whole with film = Film.with_exposure 0.1 film };
  check "encoding" (Some "one is srgb")
    { whole with film = Film.with_srgb true film };
  check "version" (Some "the versions of raylab differ, 0.1.0 and 0.2.0")
    { whole with version = "0.2.0" }

(* {1 Laws} *)

let any_band =
  let open QCheck2.Gen in
  let size = oneof [ int_range 1 100; int_range 1 Camera.max_size ] in
  let* width = size and* height = size and* grey = bool and* text = string in
  let* version =
    string_size (int_range 1 32)
      ~gen:(oneof [ numeral; char_range 'a' 'z'; oneofl [ '.'; '~'; '+' ] ])
  in
  let* film = Generate.film in
  let* first = int_bound (height - 1) in
  let* last = int_range first (height - 1) in
  let whole =
    { Band.width; height; grey; film; scene = Digest.string text; version }
  in
  return (Band.make whole ~first ~last)

let any_crc = QCheck2.Gen.(map (Crc32.add Crc32.empty) string)
let print (band, crc) = Band.label band crc

let suite =
  ( "Labels",
    [
      Alcotest.test_case "an example" `Quick test_example;
      Alcotest.test_case "checksum" `Quick test_checksum;
      Alcotest.test_case "no labels" `Quick test_no_label;
      Alcotest.test_case "what is no band" `Quick test_make;
      Alcotest.test_case "what belongs together" `Quick test_difference;
      Property.holds "a label reads back" ~print
        QCheck2.Gen.(pair any_band any_crc)
        (fun (band, crc) ->
          let label = Band.label band crc in
          String.length label <= 250
          && Band.of_label label = Some (band, Crc32.to_hex crc));
      Property.holds "any text is a label or none"
        QCheck2.Gen.(map (fun s -> "raylab-band 2 rows " ^ s) string)
        (fun text -> Band.of_label text = None);
    ] )
