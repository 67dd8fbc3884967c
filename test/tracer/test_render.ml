open Raylab_scene
open Raylab_tracer
open Test_support
open Build

let print = Property.show Scene.pp
let fst_of ?domains ?rows t = fst (Render.picture ?domains ?rows t)

(* Pictures of several tiles, and of sides that are no multiple of one. *)
let scenes = Generate.scene ~max_side:40 Generate.everyday

let any_domains =
  Property.holds "the same from 1, 2 and 4 domains" ~count:60 ~print scenes
    (fun scene ->
      let prepared = Prepared.make scene in
      let one = fst_of ~domains:1 prepared in
      Picture.equal one (fst_of ~domains:2 prepared)
      && Picture.equal one (fst_of ~domains:4 prepared))

let every_pixel =
  Property.holds "every pixel is traced" ~count:60 ~print scenes (fun scene ->
      let prepared = Prepared.make scene in
      let picture = fst_of ~domains:2 prepared in
      List.for_all
        (fun (x, y) ->
          Picture.get picture ~x ~y
          = Film.to_bytes scene.film (Tracer.pixel prepared ~x ~y))
        (Shot.pixels picture))

let bands =
  Property.holds "rows are those rows of the whole" ~count:60
    QCheck2.Gen.(triple scenes (0 -- 100) (0 -- 100))
    (fun (scene, a, b) ->
      let height = scene.camera.height in
      let first = min (a mod height) (b mod height)
      and last = max (a mod height) (b mod height) in
      let prepared = Prepared.make scene in
      let whole = fst_of ~domains:1 prepared
      and band = fst_of ~domains:2 ~rows:{ first; last } prepared in
      Picture.width band = scene.camera.width
      && Picture.height band = last - first + 1
      && List.for_all
           (fun (x, y) ->
             Picture.get band ~x ~y = Picture.get whole ~x ~y:(first + y))
           (Shot.pixels band))

let scene width height = Prepared.make (Scene.make (camera ~width ~height ()))

let test_sizes () =
  List.iter
    (fun (width, height) ->
      let picture = fst_of ~domains:4 (scene width height) in
      Alcotest.(check (pair int int))
        "size" (width, height)
        (Picture.width picture, Picture.height picture))
    [ (1, 1); (1, 37); (37, 1); (16, 16); (17, 33) ]

let test_rows () =
  let { Render.first; last } = Render.all_rows (scene 2 7) in
  Alcotest.(check (pair int int)) "all" (0, 6) (first, last);
  List.iter
    (fun (first, last) ->
      Expect.invalid "rows" (fun () ->
          Render.picture ~rows:{ first; last } (scene 2 7)))
    [ (-1, 3); (0, 7); (4, 3); (7, 7) ];
  List.iter
    (fun domains ->
      Expect.invalid "domains" (fun () -> Render.picture ~domains (scene 2 7)))
    [ 0; -1; 129 ]

(* It tells of parts that are done, ever more, and at the end of all. *)
let test_progress () =
  let told = ref [] in
  ignore
    (Render.picture ~domains:1
       ~on_progress:(fun part -> told := part :: !told)
       (scene 50 50));
  Alcotest.check Same.number "all" 1. (List.hd !told);
  Alcotest.(check bool)
    "in order" true
    (List.sort Float.compare !told = List.rev !told)

exception Stop

(* One domain: several might be done before the calling one has a tile. *)
let test_interrupted () =
  match
    Render.picture ~domains:1 ~on_progress:(fun _ -> raise Stop) (scene 90 90)
  with
  | _ -> Alcotest.fail "not stopped"
  | exception Stop -> ()

(* Pass by pass, and each of its tiles in turn: 1,000 x 800 pixels every 16th,
   8th, 4th, 2nd, each. *)
let test_coarse_first () =
  let scene = scene 1000 800 in
  let picture = Render.blank scene in
  let told = ref [] in
  ignore
    (Render.refine ~domains:1 picture scene ~on_tile:(fun pass tile ->
         told := (Pass.step pass, tile) :: !told)
      : Tally.t);
  let expected =
    List.concat_map
      (fun (step, side) ->
        let count = Tile.count ~side ~width:1000 ~height:800 in
        List.init count (fun k ->
            (step, Tile.nth ~side ~width:1000 ~height:800 k)))
      [ (16, 32); (8, 16); (4, 16); (2, 16); (1, 16) ]
  in
  Alcotest.(check bool) "in order" true (List.rev !told = expected);
  Alcotest.(check bool)
    "the picture" true
    (Picture.equal picture (fst_of scene))

let suite =
  ( "Render",
    [
      any_domains;
      every_pixel;
      bands;
      Alcotest.test_case "sizes" `Quick test_sizes;
      Alcotest.test_case "rows" `Quick test_rows;
      Alcotest.test_case "progress" `Quick test_progress;
      Alcotest.test_case "interrupted" `Quick test_interrupted;
      Alcotest.test_case "coarse first" `Quick test_coarse_first;
    ] )
