open Raylab_scene
open Raylab_tracer
open Raylab_viewer

(* small ones, and such for which the first pass is coarser than usual *)
let size =
  QCheck.(
    oneof
      [
        pair (int_range 1 70) (int_range 1 70);
        pair (int_range 1 9) (int_range 1 90_000);
        pair (int_range 600 1500) (int_range 400 800);
      ])

let tiles pass (width, height) =
  List.init (Pass.count pass ~width ~height) (Pass.nth pass ~width ~height)

let passes (width, height) = Array.to_list (Pass.coarse_to_fine ~width ~height)

let start picture =
  let width = Picture.width picture and height = Picture.height picture in
  Refinement.start ~passes:(Pass.coarse_to_fine ~width ~height) picture

(* how often the passes compute each pixel *)
let times ((width, height) as size) passes =
  let times = Array.make_matrix height width 0 in
  List.iter
    (fun pass ->
      List.iter
        (fun tile ->
          Pass.iter pass tile (fun ~x ~y -> times.(y).(x) <- times.(y).(x) + 1))
        (tiles pass size))
    passes;
  times

let all_once times = Array.for_all (Array.for_all (( = ) 1)) times

let prop_once =
  QCheck.Test.make ~count:50
    ~name:"all passes together compute each pixel once" size (fun size ->
      all_once (times size (passes size)))

let prop_whole =
  QCheck.Test.make ~count:50 ~name:"so does the whole in one pass" size
    (fun size -> all_once (times size [ Pass.whole ]))

let prop_pixels =
  QCheck.Test.make ~count:50 ~name:"pixels are as many as are computed" size
    (fun size ->
      List.for_all
        (fun pass ->
          List.for_all
            (fun tile ->
              let count = ref 0 in
              Pass.iter pass tile (fun ~x:_ ~y:_ -> incr count);
              !count = Pass.pixels pass tile)
            (tiles pass size))
        (Pass.whole :: passes size))

(* So a first picture of any size is there at once. *)
let prop_few_at_first =
  let side = QCheck.map (fun (a, b) -> 1 + (a lsl b)) in
  let side = side QCheck.(pair (int_bound 1000) (int_bound 20)) in
  QCheck.Test.make ~name:"the first pass computes few pixels of any size"
    QCheck.(pair side side)
    (fun size ->
      let first = List.hd (passes size) in
      let pixels =
        List.fold_left
          (fun sum tile -> sum + Pass.pixels first tile)
          0 (tiles first size)
      in
      1 <= pixels && pixels <= 5000)

(* Here a pixel is white once a pass has computed it. *)
let prop_known =
  let white = Color.white in
  QCheck.Test.make ~count:50
    ~name:"what is shown was computed, in whichever order"
    QCheck.(pair size (list (pair small_nat small_nat)))
    (fun (((width, height) as size), work) ->
      let picture = Picture.create ~width ~height in
      let r = start picture in
      let passes = Array.of_list (passes size) in
      List.iter
        (fun (p, k) ->
          let pass = passes.(p mod Array.length passes) in
          let count = Pass.count pass ~width ~height in
          let tile = Pass.nth pass ~width ~height (k mod count) in
          Pass.iter pass tile (fun ~x ~y -> Picture.set picture ~x ~y white);
          Refinement.note r pass tile)
        (List.sort_uniq compare work);
      List.for_all
        (fun y ->
          List.for_all
            (fun x ->
              Refinement.step r ~x ~y = 0
              || Refinement.color r ~x ~y = 0xffffff)
            (List.init width Fun.id))
        (List.init height Fun.id))

(* a picture in which every pixel has a colour of its own *)
let colour x y = (x lsl 16) lor (y lsl 8)

let filled (width, height) =
  let picture = Picture.create ~width ~height in
  let bytes = Picture.to_rgb picture in
  for y = 0 to height - 1 do
    for x = 0 to width - 1 do
      Bytes.set_uint8 bytes (3 * ((y * width) + x)) x;
      Bytes.set_uint8 bytes ((3 * ((y * width) + x)) + 1) y
    done
  done;
  picture

let color r x y =
  if Refinement.step r ~x ~y = 0 then None else Some (Refinement.color r ~x ~y)

let test_blocks () =
  let size = (40, 20) in
  let r = start (filled size) in
  let check name expected x y =
    Alcotest.(check (option int)) name expected (color r x y)
  in
  let pass = List.nth (passes size) in
  let tile = List.hd (tiles (pass 0) size) in
  check "nothing is known" None 5 5;
  Refinement.note r (pass 0) tile;
  check "blocks of 8" (Some (colour 0 8)) 5 11;
  check "another tile" None 16 0;
  Refinement.note r (pass 2) tile;
  check "a pass does not count before those before it" (Some (colour 0 8)) 5 11;
  Refinement.note r (pass 1) tile;
  check "blocks of 2" (Some (colour 4 10)) 5 11;
  Refinement.note r (pass 3) tile;
  check "pixels" (Some (colour 5 11)) 5 11;
  Alcotest.(check (float 1e-9)) "part" (256. /. 800.) (Refinement.part r)

let test_covered () =
  let size = (40, 20) in
  let r = start (filled size) in
  let check name expected =
    Alcotest.(check bool) name expected (Refinement.is_covered r)
  in
  let first, second =
    match passes size with a :: b :: _ -> (a, b) | _ -> assert false
  in
  check "nothing is known" false;
  List.iter (Refinement.note r second) (tiles second size);
  check "a pass does not count before the first" false;
  let first_tiles = tiles first size in
  List.iter (Refinement.note r first) (List.tl first_tiles);
  check "a tile lacks" false;
  Refinement.note r first (List.hd first_tiles);
  check "everywhere" true;
  Alcotest.(check bool)
    "at once" true
    (Refinement.is_covered (Refinement.complete (filled size)))

(* The first pass of 1,000 x 800 pixels is done in tiles of 32. *)
let test_large () =
  let r = start (filled (1000, 800)) in
  let pass = List.nth (passes (1000, 800)) in
  let note k =
    Refinement.note r (pass k) (Pass.nth (pass k) ~width:1000 ~height:800 0)
  in
  let check name expected x y =
    Alcotest.(check (option int)) name expected (color r x y)
  in
  note 0;
  check "blocks of 16" (Some (colour 16 0)) 31 15;
  check "another tile" None 32 0;
  note 1;
  check "blocks of 8" (Some (colour 8 8)) 15 15;
  check "another tile of the second pass" (Some (colour 16 0)) 31 15

(* A collection would stop the domains that render. *)
let test_words () =
  let width = 3000 and height = 2000 in
  let r = start (Picture.unset ~width ~height) in
  let pass = List.hd (passes (width, height)) in
  let tiles = tiles pass (width, height) in
  let before = Gc.minor_words () in
  List.iter (Refinement.note r pass) tiles;
  let squares = Tile.count ~side:Tile.side ~width ~height in
  let words = (Gc.minor_words () -. before) /. float_of_int squares in
  Alcotest.(check bool) "none for a square" true (words < 1.)

let test_complete () =
  let r = Refinement.complete (filled (33, 17)) in
  Alcotest.(check (float 0.)) "part" 1. (Refinement.part r);
  Alcotest.(check (option int)) "pixel" (Some (colour 32 16)) (color r 32 16)

let suite =
  ( "Refinement",
    List.map QCheck_alcotest.to_alcotest
      [ prop_once; prop_whole; prop_pixels; prop_few_at_first; prop_known ]
    @ [
        Alcotest.test_case "blocks" `Quick test_blocks;
        Alcotest.test_case "covered" `Quick test_covered;
        Alcotest.test_case "blocks of a large picture" `Quick test_large;
        Alcotest.test_case "complete" `Quick test_complete;
        Alcotest.test_case "no words a square" `Quick test_words;
      ] )
