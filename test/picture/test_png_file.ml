open Raylab_tracer
open Raylab_picture

(* No two pictures are as hard to pack. *)
let noise ~width ~height =
  let picture = Picture.create ~width ~height in
  let state = Random.State.make [| width; height |] in
  let rgb = Picture.to_rgb picture in
  for k = 0 to Bytes.length rgb - 1 do
    Bytes.set_uint8 rgb k (Random.State.int state 256)
  done;
  picture

let write ?label picture path =
  Out_channel.with_open_bin path (fun channel ->
      Png_file.write { (Pixels.of_picture picture) with label } channel)

let read path ~width ~height =
  In_channel.with_open_bin path (fun channel ->
      Png_file.read channel ~width ~height)

(* The names of the chunks, and the length of what each holds. *)
let chunks path =
  let text = Sample.read path in
  let rec from at =
    if at = String.length text then []
    else
      let length = Int32.to_int (String.get_int32_be text at) in
      (String.sub text (at + 4) 4, length) :: from (at + 12 + length)
  in
  from 8

let path folder = Filename.concat folder "a.png"

(* Sizes at which the library that wrote PNG before would crash, rows of more
   than is packed at once, and more than one chunk. *)
let test_sizes folder =
  let path = path folder in
  List.iter
    (fun (width, height) ->
      let picture = noise ~width ~height in
      write picture path;
      Alcotest.(check bool)
        (Printf.sprintf "%d x %d" width height)
        true
        (read path ~width ~height = Some (Picture.to_rgb picture)))
    [ (30_000, 2); (2, 30_000); (400_000, 2); (200, 200) ];
  let data = List.filter (fun (name, _) -> name = "IDAT") (chunks path) in
  Alcotest.(check bool)
    "small chunks" true
    (List.length data >= 2
    && List.for_all (fun (_, length) -> length <= 1 lsl 17) data)

let test_plain folder =
  let path = path folder in
  write (noise ~width:3 ~height:2) path;
  Alcotest.(check (list string))
    "the least there may be" [ "IHDR"; "IDAT"; "IEND" ]
    (List.map fst (chunks path));
  Alcotest.(check string)
    "3 x 2, 8 bits, colours, not interlaced"
    "\000\000\000\003\000\000\000\002\008\002\000\000\000"
    (String.sub (Sample.read path) 16 13)

let test_label folder =
  let path = path folder in
  let picture = noise ~width:3 ~height:2 in
  let found () = Png_file.label (Sample.read path) in
  write picture path;
  Alcotest.(check (option string)) "none" None (found ());
  write ~label:"a b" picture path;
  Alcotest.(check (option string)) "found" (Some "a b") (found ());
  Alcotest.(check bool)
    "no matter" true
    (read path ~width:3 ~height:2 = Some (Picture.to_rgb picture));
  let text = Sample.read path in
  for length = 0 to 33 + 8 + String.length "Comment\000a " do
    Alcotest.(check (option string))
      "cut" None
      (Png_file.label (String.sub text 0 length))
  done

let test_refused folder =
  let path = path folder in
  write (noise ~width:3 ~height:2) path;
  let refused what = Alcotest.(check bool) what true in
  refused "wider" (read path ~width:4 ~height:2 = None);
  refused "lower" (read path ~width:3 ~height:1 = None);
  Sample.write path "";
  refused "empty" (read path ~width:3 ~height:2 = None)

let test name f = Alcotest.test_case name `Quick (Sample.in_new_folder f)

let suite =
  ( "PNG files",
    [
      test "any size" test_sizes;
      test "plain" test_plain;
      test "labels" test_label;
      test "what is refused" test_refused;
    ] )
