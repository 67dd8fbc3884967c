open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Raylab_drawing
open Test_support
open Build

let draw scene =
  let prepared = Prepared.make scene in
  let pixel = Explain.pixel prepared ~x:0 ~y:0 in
  (Explain.centre pixel, Path_picture.to_svg scene pixel)

(* [count part text] is how often [part] is in [text]. *)
let count part text =
  let n = String.length part in
  let rec from i found =
    if i + n > String.length text then found
    else if String.sub text i n = part then from (i + n) (found + 1)
    else from (i + 1) found
  in
  from 0 0

let check_count what expected part text =
  Alcotest.(check int) what expected (count part text)

let white = Surface.diffusive Color.white

let test_elements () =
  let _, svg = draw Test_path.scene in
  (* in two views; dashed lines and crosses are in the legend once more *)
  check_count "dashed rays" ((2 * 2) + 2) {|stroke-dasharray="6 4"|} svg;
  check_count "crosses"
    (2 * (2 + 1))
    {|stroke="#d32f2f" stroke-width="2.4"|} svg;
  List.iter
    (fun label -> check_count label 2 (">" ^ label ^ "</text>") svg)
    [ "eye"; "canvas"; "plane 1"; "plane 2"; "sphere 3"; "light 1"; "light 2" ]

let test_unfollowed () =
  let mirror = plane (v 0. 0. 4.) (v 0. 1. 1.) Surface.reflective in
  let _, svg =
    draw (Scene.make ~ray_depth:1 ~objects:[ mirror ] (camera ()))
  in
  check_count "stub" 2 "the chain has ended</text>" svg

(* A pane before the eye, of which a part is mirrored, and green light on the
   wall behind it. *)
let test_glass () =
  let green = Surface.refractive ~index:1. (rgb 0. 1. 0.) in
  let sun =
    Light.directional ~intensity:1. ~color:Color.white ~direction:(v 0. 0. 1.)
  and pane surface = plane (v 0. 0. 2.) (v 0. 0. (-1.)) surface
  and wall = plane (v 0. 0. 4.) (v 0. 0. 1.) white in
  let draw surface =
    snd
      (draw
         (Scene.make ~lights:[ sun ]
            ~objects:[ pane surface; wall ]
            (camera ())))
  in
  let svg = draw green in
  check_count "in the legend" 1 ">refracted</text>" svg;
  check_count "green light" 2
    {|stroke="#0c0" stroke-width="1.6" stroke-dasharray|} svg;
  check_count "not mirrored" 0 {|to the background</text>|} svg;
  let svg = draw (Surface.glass ~index:1.5 Color.white) in
  check_count "a mirrored ray, too" 2 "to the background</text>" svg;
  check_count "light that has no colour" 0 {|stroke="#0c0"|} svg

(* A piece of a plane is a polygon; far beyond the panel it is nothing. *)
let test_patch () =
  let space = Box3.make ~low:(v 0. 0. 0.) ~high:(v 10. 10. 10.) in
  let panel =
    let width = 100. and height = 100. and scale = 10. in
    { Panel.side = Above; left = 0.; top = 0.; width; height; scale; space }
  in
  let draw corners =
    let s = { Silhouette.fill = Seen Color.red; is_met = true } in
    Silhouette.draw panel s ~level:0. (Patch corners)
  in
  (match draw [ v 1. 5. 1.; v 3. 5. 1.; v 2. 5. 4. ] with
  | [] | _ :: _ :: _ -> Alcotest.fail "not one"
  | [ (marks, (x, y)) ] ->
      Expect.contains "corners" ~part:"10.0,90.0 30.0,90.0 20.0,60.0"
        (String.concat "" (List.map Svg.mark marks));
      Alcotest.check (Same.near 1e-9) "label, across" 20. x;
      Alcotest.check (Same.near 1e-9) "label, above the middle" 73. y);
  Alcotest.(check bool)
    "far away" true
    (draw [ v 0. 0. 0.; v 1e9 0. 0.; v 0. 0. 1e9 ] = [])

(* A torus is all its pieces, around its hole. *)
let test_body () =
  let torus centre =
    Object.make
      (Shape.torus ~centre ~axis:(v 0. 1. 0.) ~ring:2. ~tube:0.5)
      Surface.reflective
  in
  let scene = Scene.make ~objects:[ torus (v 0. 0. 6.) ] (camera ()) in
  let _, svg = draw scene in
  check_count "24 pieces in each of two panels" 48 {|stroke-width="0.5"|} svg

(* A parallelogram is one in both panels, seen from its edge in one of them; of a
   cone there are two sides and a rim. An area light of 2 x 2 has four shadow
   rays. *)
let test_lamps () =
  let wall = plane (v 0. 0. 4.) (v 0. 0. 1.) white in
  let svg lights =
    snd (draw (Scene.make ~lights ~objects:[ wall ] (camera ())))
  in
  let area =
    Light.area ~intensity:9. ~color:Color.white
      (Pane.make ~corner:(v (-1.) 2. 0.) ~edge:(v 2. 0. 0.) ~other:(v 0. 0. 2.)
         ~count:2)
  and spot outer =
    Light.spot ~intensity:9. ~color:Color.white
      (Beam.make_exn ~position:(v 0. 1. 0.) ~target:(v 0. 0. 3.) ~inner:5.
         ~outer)
  in
  let dashed = {|stroke-dasharray="6 4"|} in
  check_count "rays to its points" ((2 * 4) + 2) dashed (svg [ area ]);
  check_count "its name" 2 ">light 1</text>" (svg [ area ]);
  let pen = {|stroke="#b26a00"|} in
  let lines outer = count pen (svg [ spot outer ]) in
  Alcotest.(check bool) "a cone" true (lines 20. > lines 120. + 10);
  Alcotest.(check int)
    "none as wide as half of space" (lines 120.)
    (count pen
       (svg
          [
            Light.spherical ~intensity:9. ~color:Color.white
              ~position:(v 0. 1. 0.);
          ]))

(* {1 Any scene} *)

let is_sound svg =
  count "nan" svg = 0
  && count "inf" svg = 0
  && String.starts_with ~prefix:"<svg" svg
  && String.ends_with ~suffix:"</svg>\n" svg

let sound =
  Any.holds "no number is out of range" ~count:60 ~max_side:4 (fun scene ->
      List.for_all
        (fun pixel ->
          is_sound (Path_picture.to_svg scene.Prepared.scene pixel))
        (Any.explained scene))

let test_many () =
  let ball i =
    let at k = float_of_int (k - 50) /. 10. in
    sphere (v (at (i mod 100)) (at (i / 100)) 5.) 0.01 white
  in
  let objects = List.init 10_000 ball in
  let _, svg = draw (Scene.make ~objects (camera ())) in
  let circles = count "<circle" svg in
  Alcotest.(check bool) "some hundreds" true (300 < circles && circles < 800)

(* A star far away and a huge planet make no dots of the rest. *)
let test_extent () =
  let near =
    List.init 3 (fun k -> sphere (v (float_of_int k) 0. 4.) 1. white)
  in
  let extent objects =
    let scene = Scene.make ~objects (camera ()) in
    Extent.of_path scene (Path.of_rays scene.film [ fst (draw scene) ])
  in
  let alone = extent near
  and crowded =
    extent
      (near
      @ [
          sphere (v 0. 900. 4.) 1. white;
          sphere (v 0. (-6e6) 0.) 5.9e6 white;
          plane (v 0. (-500.) 0.) (v 0. 1. 0.) white;
        ])
  in
  Alcotest.(check bool) "the same" true (compare alone crowded = 0);
  Alcotest.(check bool) "the ball is in it" true (alone.high.z >= 5.)

let suite =
  ( "Path_picture",
    [
      Alcotest.test_case "elements" `Quick test_elements;
      Alcotest.test_case "a chain that ends" `Quick test_unfollowed;
      Alcotest.test_case "thousands of spheres" `Quick test_many;
      Alcotest.test_case "extent" `Quick test_extent;
      Alcotest.test_case "glass" `Quick test_glass;
      Alcotest.test_case "a piece of a plane" `Quick test_patch;
      Alcotest.test_case "a body" `Quick test_body;
      Alcotest.test_case "lamps" `Quick test_lamps;
    ]
    @ sound )
