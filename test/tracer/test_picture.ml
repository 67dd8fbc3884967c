open Raylab_tracer
open Test_support
open Build

let test_pixels () =
  let picture = Picture.create ~width:3 ~height:2 in
  let check what expected ~x ~y =
    Alcotest.check Same.levels what expected (Picture.get picture ~x ~y)
  in
  check "black at first" (0, 0, 0) ~x:2 ~y:1;
  Picture.set picture ~x:1 ~y:0 (rgb 1. 0.5 0.);
  Picture.set picture ~x:2 ~y:1 (rgb 7. (-1.) nan);
  check "levels" (255, 128, 0) ~x:1 ~y:0;
  check "clamped" (255, 0, 0) ~x:2 ~y:1;
  (* second pixel of the first row, last of the second *)
  Alcotest.(check string)
    "row by row from the top"
    "\000\000\000\255\128\000\000\000\000\000\000\000\000\000\000\255\000\000"
    (Bytes.to_string (Picture.to_rgb picture))

let test_unset () =
  let picture = Picture.unset ~width:30 ~height:20 in
  Alcotest.(check (pair int int))
    "size" (30, 20)
    (Picture.width picture, Picture.height picture);
  Picture.set picture ~x:29 ~y:19 (rgb 1. 0.5 0.);
  Alcotest.check Same.levels "one is set" (255, 128, 0)
    (Picture.get picture ~x:29 ~y:19);
  Alcotest.(check int)
    "as one number" 0xff8000
    (Picture.code picture ~x:29 ~y:19)

let test_invalid () =
  let picture = Picture.create ~width:3 ~height:2 in
  List.iter
    (fun (x, y) ->
      Expect.invalid "get" (fun () -> Picture.get picture ~x ~y);
      Expect.invalid "code" (fun () -> Picture.code picture ~x ~y);
      Expect.invalid "set" (fun () -> Picture.set picture ~x ~y (grey 1.)))
    [ (3, 0); (0, 2); (-1, 0); (0, -1); (max_int, max_int) ];
  List.iter
    (fun (width, height) ->
      Expect.invalid "create" (fun () -> Picture.create ~width ~height);
      Expect.invalid "unset" (fun () -> Picture.unset ~width ~height))
    (* the bytes of the last two, counted modulo 2^63, are few *)
    [ (0, 1); (1, 0); (-1, 1); (1 lsl 40, 1 lsl 23); (1 lsl 61, 1 lsl 61) ]

let test_equal () =
  let picture ?(width = 2) ?(height = 1) color =
    let picture = Picture.create ~width ~height in
    Picture.set picture ~x:0 ~y:0 color;
    picture
  in
  let check what expected a b =
    Alcotest.(check bool) what expected (Picture.equal a b)
  in
  check "same" true (picture (grey 1.)) (picture (grey 1.));
  check "other pixel" false (picture (grey 1.)) (picture (grey 0.));
  check "other shape" false
    (picture (grey 1.))
    (picture ~width:1 ~height:2 (grey 1.))

let suite =
  ( "Picture",
    [
      Alcotest.test_case "pixels" `Quick test_pixels;
      Alcotest.test_case "unset" `Quick test_unset;
      Alcotest.test_case "invalid" `Quick test_invalid;
      Alcotest.test_case "equal" `Quick test_equal;
    ] )
