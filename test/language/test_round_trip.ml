open Raylab_scene
open Raylab_language
open Test_support
open Build

let printed = Format.asprintf "%a" Scene_file.print

let test_print () =
  let scene =
    Scene.make
      (camera ~width:4 ~height:3 ~depth:0.1 ())
      ~background:(rgb 0. 0.5 1.)
      ~lights:
        [
          Light.directional ~intensity:1. ~color:Color.white
            ~direction:(v 0. (-2.) 0.);
          Light.spherical ~intensity:2.5 ~color:Color.red
            ~position:(v 1. 2. 3.);
        ]
      ~objects:
        [
          sphere (v 0. 0. 6.) 1.
            (Surface.mixed
               Surface.[ (0.5, reflective); (2., luminous Color.blue) ]);
          plane (v 0. (-1.) 0.) (v 0. 1. 0.) (Surface.diffusive Color.green);
        ]
  in
  Alcotest.(check string)
    "one setting, light or object a line"
    "imWidth 4\n\
     imHeight 3\n\
     canvWidth 2\n\
     canvHeight 2\n\
     depth 0.1\n\
     bcolor 0 0.5 1\n\
     raydepth 4\n\
     lights\n\
     directional 1 1 1 1 0 -1 0\n\
     spherical 2.5 1 0 0 1 2 3\n\
     objects\n\
     sphere 0 0 6 1 mixed 0.5 reflective 2 luminous 0 0 1\n\
     plane 0 -1 0 0 1 0 diffusive 0 1 0\n"
    (printed scene)

let reads_back scene =
  match Read.result (printed scene) with
  | Ok again -> Scene.equal scene again
  | Error _ -> false

let everyday =
  Property.holds "print, then parse, is nothing" ~print:printed ~count:500
    (Generate.scene ~max_side:5000 Generate.everyday)
    reads_back

let extreme =
  Property.holds "with numbers of any size" ~print:printed ~count:2000
    (Generate.scene ~max_side:5000 Generate.extreme)
    reads_back

(* What is expanded has a place behind every light and object, as a comment. *)
let expanded =
  let comments text = List.length (String.split_on_char '#' text) - 1 in
  Property.holds "expand, then parse, is nothing" ~print:printed ~count:500
    (Generate.scene ~max_side:5000 Generate.everyday) (fun scene ->
      let again = Read.scene (printed scene) in
      let text = Format.asprintf "%a" Scene_file.expand again in
      Scene.equal scene (Read.scene text)
      && comments text = List.length scene.lights + List.length scene.objects)

(* A formatter with a narrow margin must not break lines. *)
let test_margin () =
  let wide =
    List.init 200 (fun k -> (float_of_int k, Surface.luminous Color.white))
  in
  let scene =
    Scene.make (camera ())
      ~objects:[ sphere (v 0. 0. 6.) 1. (Surface.mixed wide) ]
  in
  let text = Buffer.create 100 in
  let ppf = Format.formatter_of_buffer text in
  Format.pp_set_margin ppf 20;
  Format.fprintf ppf "%a@?" Scene_file.print scene;
  Alcotest.(check string) "the same" (printed scene) (Buffer.contents text)

let suite =
  ( "Round trip",
    [
      Alcotest.test_case "print" `Quick test_print;
      Alcotest.test_case "margin" `Quick test_margin;
      everyday;
      extreme;
      expanded;
    ] )
