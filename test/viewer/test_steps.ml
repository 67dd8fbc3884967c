open Raylab_scene
open Raylab_tracer
open Raylab_viewer

let scene ~width ~height =
  Prepared.make
    (Scene.make
       (Camera.make ~width ~height ~canvas_width:4. ~canvas_height:3. ~depth:4.))

let black ~width ~height = (scene ~width ~height, Picture.create ~width ~height)

let began ~width ~height =
  let scene, picture = black ~width ~height in
  Viewer.News (Began { scene; picture; first_row = 0 })

let viewer =
  Viewer.make ~name:"a.scene" ~screen:None ~window:(40, 30) ~picture:(40, 30)

(* What is asked for, in a word. *)
let word : Viewer.request -> string = function
  | Render -> "render"
  | Check_saving -> "check"
  | Save _ -> "save"
  | Print _ -> "print"
  | Tell text -> text
  | Explain { Explain.x; y; _ } -> Printf.sprintf "explain %d,%d" x y
  | Resize (width, height) -> Printf.sprintf "resize %dx%d" width height

let happen viewer events =
  List.fold_left
    (fun (viewer, words) event ->
      let viewer, requests = Viewer.step viewer event in
      (viewer, words @ List.map word requests))
    (viewer, []) events

let asks name expected viewer events =
  let viewer, words = happen viewer events in
  Alcotest.(check (list string)) name expected words;
  viewer

let text_size words = (6. *. float_of_int (String.length words), 13.)
let draw = Viewer.draw ~text_size

(* What is to be drawn, in words. *)
let seen viewer =
  let summary { Viewer.box = { left; top; width; height }; rows; over } =
    let box = Printf.sprintf "%dx%d+%d+%d" width height left top in
    let over = if over = [] then "" else " and more" in
    box ^ (if rows = None then " of nothing" else "") ^ over
  in
  Option.map summary (snd (draw viewer))

let shows name expected viewer =
  Alcotest.(check (option string)) name expected (seen viewer);
  fst (draw viewer)

let has_title title viewer =
  Alcotest.(check string) "title" title (Viewer.title viewer)

(* The passes of a picture of 40 x 30 pixels. *)
let passes = Array.to_list (Pass.coarse_to_fine ~width:40 ~height:30)
let tile pass k = Pass.nth pass ~width:40 ~height:30 k

let tiles =
  List.concat_map
    (fun pass ->
      List.init (Pass.count pass ~width:40 ~height:30) (fun k ->
          Viewer.News (Tile (pass, tile pass k))))
    passes

let rendered =
  let viewer, _ =
    happen viewer
      ((began ~width:40 ~height:30 :: tiles) @ [ News (Finished 2.) ])
  in
  viewer

let drawn = fst (draw rendered)

let test_rendering () =
  has_title "a.scene" viewer;
  let v = shows "nothing yet" (Some "40x30+0+0 of nothing") viewer in
  let v = shows "drawn once" None v in
  let v = asks "no more" [] v [ began ~width:40 ~height:30 ] in
  has_title "a.scene, 40 x 30: 0 %" v;
  let v = shows "no pixel yet" (Some "40x30+0+0 of nothing") v in
  let first = List.hd passes in
  let v = asks "no more" [] v [ News (Tile (first, tile first 1)) ] in
  Alcotest.(check bool) "there is something" true (Viewer.shows_something v);
  ignore (shows "a tile" (Some "16x16+16+0") v : Viewer.t);
  has_title "a.scene, 40 x 30: 2.00 s" rendered

let test_sizes () =
  let v =
    asks "the window fits the picture" [ "resize 80x60" ] drawn
      [ began ~width:80 ~height:60 ]
  in
  let v = asks "no more" [] v [ Resized (80, 60) ] in
  let v = shows "all" (Some "80x60+0+0 of nothing") v in
  let v = asks "no more" [] v [ Resized (80, 60) ] in
  ignore (shows "the same size" None v : Viewer.t)

let test_click () =
  let v =
    asks "the pixel there" [ "explain 20,15" ] drawn [ Clicked (20, 15) ]
  in
  let v = shows "its path" (Some "40x30+0+0 and more") v in
  let v = asks "nothing" [] v [ Pressed 'e' ] in
  let v = shows "hidden" (Some "40x30+0+0") v in
  let v = asks "nothing" [] v [ Pressed 'e' ] in
  let v = shows "again" (Some "40x30+0+0 and more") v in
  let v = asks "no more" [] v [ began ~width:40 ~height:30 ] in
  let v = shows "it follows the scene" (Some "40x30+0+0 and more") v in
  let v = asks "nothing" [] v [ Pressed 'c' ] in
  ignore (shows "cleared" (Some "40x30+0+0") v : Viewer.t);
  ignore (asks "before a picture" [] viewer [ Clicked (20, 15) ] : Viewer.t);
  ignore (asks "beside it" [] drawn [ Clicked (40, 15) ] : Viewer.t)

let test_save () =
  ignore (asks "at once" [ "save" ] drawn [ Pressed 's' ] : Viewer.t);
  let v = asks "first whether" [ "check" ] viewer [ Pressed 's' ] in
  let rest = (began ~width:40 ~height:30 :: tiles) @ [ News (Finished 2.) ] in
  let no = Viewer.Saving_checked (Error "no")
  and yes = Viewer.Saving_checked (Ok ()) in
  ignore (asks "not" [ "no" ] v (no :: rest) : Viewer.t);
  let v =
    asks "when it is whole"
      [ "the picture will be saved when it is whole"; "save" ]
      v (yes :: rest)
  in
  ignore (asks "once" [] v rest : Viewer.t)

let test_error () =
  let wrong = Viewer.News (Failed "a.scene: wrong") in
  let v = asks "told" [ "a.scene: wrong" ] drawn [ wrong ] in
  has_title "a.scene: error" v;
  let v =
    asks "no picture"
      [ "the scene is in error: there is no picture to save" ]
      v [ Pressed 's' ]
  in
  let v = asks "a pixel of the last" [ "explain 1,2" ] v [ Clicked (1, 2) ] in
  ignore (asks "again" [ "render" ] v [ Changed ] : Viewer.t);
  let v, _ =
    happen viewer [ Resized (400, 300); News (Failed "a.scene: wrong") ]
  in
  ignore (shows "why" (Some "400x300+0+0 of nothing and more") v : Viewer.t)

let test_keys () =
  let v = asks "rendered anew" [ "render" ] drawn [ Pressed 'r' ] in
  let v = asks "listed" [ "print" ] v [ Pressed 'h' ] in
  let v = asks "nothing" [] v [ Pressed 'x' ] in
  Alcotest.(check bool) "open" false (Viewer.is_closed v);
  let v = asks "nothing" [] v [ Pressed 'q' ] in
  Alcotest.(check bool) "closed" true (Viewer.is_closed v)

let test_whole () =
  let scene, picture = black ~width:40 ~height:30 in
  let refinement = Refinement.complete picture in
  let v =
    asks "no more" [] viewer
      [ Rendered ({ scene; refinement; first_row = 0 }, 2.) ]
  in
  has_title "a.scene, 40 x 30: 2.00 s" v;
  ignore (shows "all" (Some "40x30+0+0") v : Viewer.t)

let suite =
  ( "Viewer",
    [
      Alcotest.test_case "rendering" `Quick test_rendering;
      Alcotest.test_case "sizes" `Quick test_sizes;
      Alcotest.test_case "clicks" `Quick test_click;
      Alcotest.test_case "save" `Quick test_save;
      Alcotest.test_case "error" `Quick test_error;
      Alcotest.test_case "keys" `Quick test_keys;
      Alcotest.test_case "whole at once" `Quick test_whole;
    ] )
