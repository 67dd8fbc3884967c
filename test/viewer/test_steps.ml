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

let click x y = [ Viewer.Button_down (x, y); Button_up (x, y) ]

(* What is asked for, in a word. *)
let word : Viewer.request -> string = function
  | Render -> "render"
  | Look { scene; _ } ->
      Format.asprintf "look from %a" Viewpoint.pp scene.camera.viewpoint
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
  let v = asks "the pixel there" [ "explain 20,15" ] drawn (click 20 15) in
  let v = shows "its path" (Some "40x30+0+0 and more") v in
  let v = asks "nothing" [] v [ Pressed 'e' ] in
  let v = shows "hidden" (Some "40x30+0+0") v in
  let v = asks "nothing" [] v [ Pressed 'e' ] in
  let v = shows "again" (Some "40x30+0+0 and more") v in
  let v = asks "no more" [] v [ began ~width:40 ~height:30 ] in
  let v = shows "it follows the scene" (Some "40x30+0+0 and more") v in
  let v = asks "nothing" [] v [ Pressed 'c' ] in
  ignore (shows "cleared" (Some "40x30+0+0") v : Viewer.t);
  ignore (asks "before a picture" [] viewer (click 20 15) : Viewer.t);
  ignore (asks "beside it" [] drawn (click 40 15) : Viewer.t)

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
  let v = asks "a pixel of the last" [ "explain 1,2" ] v (click 1 2) in
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

(* {1 The eye} *)

(* Half the width of the picture is a quarter of a turn. *)
let drag = [ Viewer.Button_down (10, 10); Pointer_at (30, 10) ]
let from_the_left = "look from eye (-4, 0, 0), lookAt (0, 0, 0)"

let view_began scene =
  let { Camera.width; height; _ } = scene.Prepared.scene.camera in
  let picture = Picture.create ~width ~height in
  Viewer.News (Began { scene; picture; first_row = 0 })

(* The scene that [events] ask to be rendered from elsewhere. *)
let asked_for viewer events =
  let look viewer event =
    let viewer, requests = Viewer.step viewer event in
    let scene = function Viewer.Look scene -> Some scene | _ -> None in
    (viewer, List.find_map scene requests)
  in
  let viewer, found = List.fold_left_map look viewer events in
  match List.find_map Fun.id found with
  | Some scene -> (viewer, scene)
  | None -> Alcotest.fail "no picture is asked for"

let first_tiles, finer_tiles =
  let first = List.hd passes in
  List.partition
    (function Viewer.News (Tile (pass, _)) -> pass = first | _ -> false)
    tiles

let test_drag () =
  let v =
    asks "within the threshold" [] drawn
      [ Button_down (10, 10); Pointer_at (13, 7) ]
  in
  ignore
    (asks "a click" [ "explain 10,10" ] v [ Button_up (13, 7) ] : Viewer.t);
  let v = asks "beyond" [ from_the_left ] drawn drag in
  Alcotest.(check bool) "the hand holds on" true (Viewer.is_holding v);
  let v = asks "no click at the end" [] v [ Button_up (30, 10) ] in
  Alcotest.(check bool) "and lets go" false (Viewer.is_holding v);
  ignore
    (asks "a hand that was not seen on its way" [ from_the_left ] drawn
       [ Button_down (10, 10); Button_up (30, 10) ]
      : Viewer.t);
  ignore (asks "before a scene" [] viewer drag : Viewer.t)

(* One picture after the other, as fast as the coarse ones are there. *)
let test_follow () =
  let v, scene = asked_for drawn drag in
  let v =
    asks "one at a time" [] v [ Pointer_at (20, 10); Pointer_at (10, 10) ]
  in
  let v = asks "not before the first is there" [] v [ view_began scene ] in
  ignore (shows "still the one before" None v : Viewer.t);
  let almost, last =
    match List.rev first_tiles with
    | last :: almost -> (List.rev almost, last)
    | [] -> assert false
  in
  let v = asks "nor while a tile lacks" [] v almost in
  let v = shows "nor seen in part" None v in
  let v =
    asks "the next one, from where the hand is now"
      [ "look from eye (0, 0, -4), lookAt (0, 0, 0)" ]
      v [ last ]
  in
  let v = shows "the first is seen, all at once" (Some "40x30+0+0") v in
  let v = asks "no more" [] v finer_tiles in
  ignore (asks "when it is whole" [] v [ News (Finished 1.) ] : Viewer.t)

let whole_view v scene =
  let events = (view_began scene :: tiles) @ [ News (Finished 1.) ] in
  fst (happen v events)

let test_view_keys () =
  let v =
    asks "nearer"
      [ "look from eye (0, 0, -3.2), lookAt (0, 0, 0)" ]
      drawn [ Pressed '+' ]
  in
  ignore (v : Viewer.t);
  let v, scene = asked_for drawn [ Pressed '-' ] in
  let v = whole_view v scene in
  let v, words = happen v [ Pressed 'v' ] in
  Alcotest.(check (list string)) "printed" [ "print" ] words;
  let v =
    asks "back"
      [ "look from eye (0, 0, -4), lookAt (0, 0, 0)" ]
      v [ Pressed '0' ]
  in
  ignore
    (asks "not to be saved before the eye is there" [ "check" ] v
       [ Pressed 's' ]
      : Viewer.t);
  ignore (asks "already there" [] drawn [ Pressed '0' ] : Viewer.t);
  ignore (v : Viewer.t)

(* The view stays as long as the file has the same one. *)
let test_view_and_file () =
  let v, scene = asked_for drawn drag in
  let v = whole_view v scene in
  let v = asks "read again" [ "render" ] v [ Changed ] in
  let kept =
    asks "from there, too" [ from_the_left ] v [ began ~width:40 ~height:30 ]
  in
  ignore (kept : Viewer.t);
  let elsewhere =
    let scene, picture = black ~width:40 ~height:30 in
    let viewpoint = Viewpoint.make_exn (Raylab_geometry.Vec3.make 5. 0. 0.) in
    let camera = Camera.with_viewpoint viewpoint scene.Prepared.scene.camera in
    let scene = Prepared.with_camera camera scene in
    Viewer.News (Began { scene; picture; first_row = 0 })
  in
  let v = asks "its own, if it is a new one" [] v (elsewhere :: tiles) in
  ignore
    (asks "nor does a hand move the eye of a scene in error" [ "wrong" ] v
       (News (Failed "wrong") :: drag)
      : Viewer.t)

(* {1 Messages} *)

let large =
  let v =
    Viewer.make ~name:"a.scene" ~screen:None ~window:(400, 300)
      ~picture:(40, 30)
  in
  let events =
    (began ~width:40 ~height:30 :: tiles) @ [ News (Finished 2.) ]
  in
  fst (happen v events)

let words_over viewer =
  match snd (draw (fst (happen viewer [ Resized (401, 300) ]))) with
  | None -> ""
  | Some { over; _ } ->
      let words : Raylab_drawing.Drawing.mark -> _ = function
        | Text { words; _ } -> Some words
        | _ -> None
      in
      String.concat " " (List.filter_map words over)

let test_messages () =
  let check name ~starts events =
    let v, _ = happen large events in
    let words = words_over v in
    if not (String.starts_with ~prefix:starts words) then
      Alcotest.failf "%s: %s" name words
  in
  let none name events =
    let v, _ = happen large events in
    Alcotest.(check string) name "" (words_over v)
  in
  let a_click = click 200 150 in
  check "why a pixel is so" ~starts:"pixel (20, 15) is rgb 0 0 0: the black"
    a_click;
  none "hidden" (a_click @ [ Pressed 'e' ]);
  none "cleared" (a_click @ [ Pressed 'c' ]);
  check "the keys" ~starts:"click  explain" [ Pressed 'h' ];
  none "gone with the next" [ Pressed 'h'; Pressed 'x' ];
  check "where it is saved" ~starts:"raylab: wrote a.bmp"
    [ Pressed 's'; Saved "raylab: wrote a.bmp" ];
  check "a view" ~starts:"eye 0 0 -4   lookAt 0 0 0" [ Pressed 'v' ]

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
      Alcotest.test_case "drags" `Quick test_drag;
      Alcotest.test_case "following a hand" `Quick test_follow;
      Alcotest.test_case "keys for the view" `Quick test_view_keys;
      Alcotest.test_case "the view and the file" `Quick test_view_and_file;
      Alcotest.test_case "messages" `Quick test_messages;
    ] )
