open Raylab_picture

(* Two rows of one pixel each, worked out by hand. *)
let test_bmp_rows () =
  let rgb = Bytes.of_string "rgbRGB" in
  let bmp = Bytes.of_string "BGR\000bgr\000" in
  Alcotest.(check bytes) "decoded" rgb (Uncompressed.decode Bmp ~width:1 bmp);
  Alcotest.(check int) "stride" 4 (Uncompressed.stride Bmp ~width:1)

let test_labels () =
  let check format label =
    let start = Uncompressed.header format ~label ~width:3 ~height:2
    and stop = "pixels" ^ Uncompressed.trailer format ~label in
    Alcotest.(check (option string))
      "found" label
      (Uncompressed.label format ~start ~stop);
    let half text = String.sub text 0 (String.length text / 2) in
    Alcotest.(check (option string))
      "not in a half" None
      (Uncompressed.label format ~start:(half start) ~stop:(half stop));
    Alcotest.(check (option string))
      "not in nothing" None
      (Uncompressed.label format ~start:"" ~stop:"")
  in
  List.iter
    (fun format ->
      check format None;
      check format (Some "a b"))
    [ Uncompressed.Bmp; Ppm ];
  Alcotest.(check (option string))
    "another format" None
    (Uncompressed.label Bmp ~start:"P6\n# a b\n" ~stop:"\na b\n")

let suite =
  ( "Uncompressed",
    [
      Alcotest.test_case "rows of a BMP" `Quick test_bmp_rows;
      Alcotest.test_case "labels" `Quick test_labels;
    ] )
