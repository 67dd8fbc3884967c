open Raylab_tracer
open Raylab_window

let size = QCheck.(pair (int_range 1 70) (int_range 1 70))

let tiles (width, height) =
  List.init (Tile.count ~width ~height) (Tile.nth ~width ~height)

let passes = Array.to_list Pass.coarse_to_fine

(* how often the passes compute each pixel *)
let times ((width, height) as size) passes =
  let times = Array.make_matrix height width 0 in
  List.iter
    (fun pass ->
      List.iter
        (fun tile ->
          Pass.iter pass tile (fun ~x ~y -> times.(y).(x) <- times.(y).(x) + 1))
        (tiles size))
    passes;
  times

let all_once times = Array.for_all (Array.for_all (( = ) 1)) times

let prop_once =
  QCheck.Test.make ~name:"all passes together compute each pixel once" size
    (fun size -> all_once (times size passes))

let prop_whole =
  QCheck.Test.make ~name:"so does the whole in one pass" size (fun size ->
      all_once (times size [ Pass.whole ]))

let prop_pixels =
  QCheck.Test.make ~name:"pixels are as many as are computed" size (fun size ->
      List.for_all
        (fun pass ->
          List.for_all
            (fun tile ->
              let count = ref 0 in
              Pass.iter pass tile (fun ~x:_ ~y:_ -> incr count);
              !count = Pass.pixels pass tile)
            (tiles size))
        (Pass.whole :: passes))

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

let test_blocks () =
  let size = (40, 20) in
  let r = Refinement.start (filled size) in
  let check name expected x y =
    Alcotest.(check (option int)) name expected (Refinement.color r ~x ~y)
  in
  let tile = List.hd (tiles size) in
  let pass k = Pass.coarse_to_fine.(k) in
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

let test_complete () =
  let r = Refinement.complete (filled (33, 17)) in
  Alcotest.(check (float 0.)) "part" 1. (Refinement.part r);
  Alcotest.(check (option int))
    "pixel"
    (Some (colour 32 16))
    (Refinement.color r ~x:32 ~y:16)

let suite =
  ( "Refinement",
    List.map QCheck_alcotest.to_alcotest [ prop_once; prop_whole; prop_pixels ]
    @ [
        Alcotest.test_case "blocks" `Quick test_blocks;
        Alcotest.test_case "complete" `Quick test_complete;
      ] )
