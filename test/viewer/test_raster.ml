open Raylab_scene
open Raylab_tracer
open Raylab_viewer

let raster ~window ~picture =
  Raster.make (Layout.make ~window ~picture) ~background:7

(* rows of a picture whose pixels are all known *)
let rows ~window ~picture color ~top ~height =
  let look = { Raster.color; step = (fun ~x:_ ~y:_ -> 1) } in
  Raster.rows (raster ~window ~picture) look ~top ~height

let matrix = Alcotest.(array (array int))
let number ~x ~y = (10 * y) + x

let test_itself () =
  Alcotest.check matrix "pixel by pixel"
    [| [| 10; 11; 12 |]; [| 20; 21; 22 |] |]
    (rows ~window:(3, 4) ~picture:(3, 4) number ~top:1 ~height:2)

let test_beside () =
  Alcotest.check matrix "background"
    [| [| 7; 7; 7 |]; [| 0; 0; 0 |]; [| 7; 7; 7 |] |]
    (rows ~window:(3, 3) ~picture:(3, 1) (fun ~x:_ ~y:_ -> 0) ~top:0 ~height:3)

let test_magnified () =
  Alcotest.check matrix "squares"
    [| [| 0; 0; 1; 1 |]; [| 0; 0; 1; 1 |] |]
    (rows ~window:(4, 2) ~picture:(2, 1) number ~top:0 ~height:2)

let test_mean () =
  let color ~x ~y:_ = if x land 1 = 0 then 0xff0000 else 0x0000ff in
  Alcotest.check matrix "of all four"
    [| [| 0x800080; 0x800080 |] |]
    (rows ~window:(2, 2) ~picture:(4, 4) color ~top:0 ~height:1);
  let color ~x ~y:_ = if x < 500 then 0 else 0xffffff in
  Alcotest.check matrix "of some of many" [| [| 0x808080 |] |]
    (rows ~window:(1, 1) ~picture:(1000, 1000) color ~top:0 ~height:1)

(* Of a picture in blocks few colours are asked for, however many pixels there
   are, and no mean is made. *)
let test_blocks () =
  let asked = ref 0 in
  let color ~x ~y =
    incr asked;
    number ~x:(x / 64) ~y:(y / 64)
  in
  let look = { Raster.color; step = (fun ~x:_ ~y:_ -> 64) } in
  let rows =
    Raster.rows
      (raster ~window:(320, 160) ~picture:(1280, 640))
      look ~top:0 ~height:160
  in
  Alcotest.(check int) "20 blocks in each row" (160 * 20) !asked;
  Alcotest.(check int) "left of an edge" 94 rows.(159).(79);
  Alcotest.(check int) "right of it" 95 rows.(159).(80)

(* Unknown pixels beside known ones. *)
let test_unknown () =
  let color ~x ~y:_ = x and step ~x ~y:_ = if x < 2 then 0 else 1 in
  Alcotest.check matrix "each for itself"
    [| [| 0; 1; 2; 3 |] |]
    (Raster.rows
       (raster ~window:(4, 1) ~picture:(4, 1))
       { color; step } ~top:0 ~height:1)

let test_again () =
  let raster = raster ~window:(3, 3) ~picture:(3, 1) in
  let rows color ~top =
    Raster.rows raster
      { color = (fun ~x:_ ~y:_ -> color); step = (fun ~x:_ ~y:_ -> 1) }
      ~top ~height:2
  in
  ignore (rows 1 ~top:0 : int array array);
  Alcotest.check matrix "background stays"
    [| [| 2; 2; 2 |]; [| 7; 7; 7 |] |]
    (rows 2 ~top:1)

(* A collection would stop the domains that render. *)
let test_words () =
  let scene =
    Scene.make
      (Camera.make ~width:1600 ~height:1200 ~canvas_width:4. ~canvas_height:3.
         ~depth:4.)
  in
  let picture = Picture.create ~width:1600 ~height:1200 in
  let look refinement =
    let scene = Prepared.make scene in
    Shown.look [ { Shown.scene; refinement; first_row = 0 } ]
  in
  let check name refinement =
    let raster = raster ~window:(400, 300) ~picture:(1600, 1200)
    and look = look refinement in
    let before = Gc.minor_words () in
    ignore (Raster.rows raster look ~top:0 ~height:300 : int array array);
    let words = (Gc.minor_words () -. before) /. (400. *. 300.) in
    Alcotest.(check bool) name true (words < 0.2)
  in
  check "known" (Refinement.complete picture);
  check "unknown" (Refinement.start ~passes:[||] picture)

let test_dim () =
  let look =
    Raster.dim
      { color = (fun ~x:_ ~y:_ -> 0xff3200); step = (fun ~x:_ ~y:_ -> 4) }
  in
  Alcotest.(check int) "three tenths" 0x4c0f00 (look.color ~x:0 ~y:0);
  Alcotest.(check int) "in the same blocks" 4 (look.step ~x:0 ~y:0)

let suite =
  ( "Raster",
    [
      Alcotest.test_case "itself" `Quick test_itself;
      Alcotest.test_case "beside the picture" `Quick test_beside;
      Alcotest.test_case "magnified" `Quick test_magnified;
      Alcotest.test_case "mean" `Quick test_mean;
      Alcotest.test_case "blocks" `Quick test_blocks;
      Alcotest.test_case "unknown" `Quick test_unknown;
      Alcotest.test_case "again" `Quick test_again;
      Alcotest.test_case "no words a pixel" `Quick test_words;
      Alcotest.test_case "dim" `Quick test_dim;
    ] )
