(* The ray from (0, 0, -1) along the z axis, through glass. *)

open Raylab_scene
open Raylab_tracer
open Test_support
open Build

let check = Alcotest.check (Same.color_near 1e-12)
let background = rgb 0.2 0.4 0.6
let white = Color.white
let glass = Surface.glass ~index:1.5 white
let wall color = plane (v 0. 0. 10.) (v 0. 0. 1.) (Surface.luminous color)
let color ?ray_depth objects = Shot.centre ~background ?ray_depth objects

(* Its outside is towards the eye. *)
let pane surface = plane (v 0. 0. 4.) (v 0. 0. (-1.)) surface

let box corner opposite surface =
  Object.make (Raylab_geometry.Shape.box_between ~corner ~opposite) surface

let mix a b part = Color.add (Color.scale (1. -. part) a) (Color.scale part b)

(* At right angles 4 % is mirrored, and shows the background. *)
let test_pane () =
  let red = rgb 8. 0. 0. in
  check "96 % of the wall" (mix red background 0.04)
    (color [ pane glass; wall red ]);
  check "in colour"
    (Color.add (Color.scale 0.04 background) (rgb 3.84 0. 0.))
    (color [ pane (Surface.glass ~index:1.5 (rgb 0.5 1. 1.)); wall red ]);
  check "refractive: all of it" (rgb 4. 0. 0.)
    (color [ pane (Surface.refractive ~index:1.5 (rgb 0.5 1. 1.)); wall red ]);
  check "from inside as much" (mix red background 0.04)
    (color [ plane (v 0. 0. 4.) (v 0. 0. 1.) glass; wall red ]);
  check "the chain ends in it" background
    (color ~ray_depth:1 [ pane glass; wall red ])

(* A block from 4 to 5. What is mirrored twice in it has 0.96 * 0.04^2 of the
   share, which is followed, and what is mirrored three times has not: it shows
   the background. *)
let test_block () =
  let wall_color = rgb 4. 2. 1. in
  let faint = background in
  let third = mix wall_color faint 0.04 in
  let second = mix background third 0.04 in
  let first = mix wall_color second 0.04 in
  check "a series"
    (mix first background 0.04)
    (color ~ray_depth:20
       [ box (v (-9.) (-9.) 4.) (v 9. 9. 5.) glass; wall wall_color ])

(* From inside at 45 degrees, beyond the critical angle of 41.8: upwards. *)
let test_total () =
  let slope surface = plane (v 0. 0. 4.) (v 0. (-1.) 1.) surface
  and above = plane (v 0. 9. 0.) (v 0. 1. 0.) (Surface.luminous white) in
  check "glass mirrors all" white (color [ slope glass; above ]);
  check "refractive in its colour" (rgb 0.5 1. 0.25)
    (color [ slope (Surface.refractive ~index:1.5 (rgb 0.5 1. 0.25)); above ]);
  check "with the mirror" (rgb 2.5 3. 2.25)
    (color
       [
         slope
           (Surface.mixed
              [
                (2., Surface.reflective);
                (1., Surface.refractive ~index:1.5 (rgb 0.5 1. 0.25));
              ]);
         above;
       ])

(* Equal indices send one ray, others one each. *)
let test_several () =
  let rays parts =
    let objects = [ pane (Surface.mixed parts); wall white ] in
    let prepared =
      Prepared.make (Scene.make (camera ()) ~background ~objects)
    in
    List.length
      (Explain.next (Explain.ray prepared (ray (v 0. 0. (-1.)) (v 0. 0. 1.))))
  in
  let through index = (0.5, Surface.refractive ~index white) in
  let count = Alcotest.(check int) in
  count "one" 1 (rays [ through 1.5 ]);
  count "two of one index" 1 (rays [ through 1.5; through 1.5 ]);
  count "two" 2 (rays [ through 1.5; through 1.6 ]);
  count "glass has two" 2 (rays [ (1., glass); through 1.5 ]);
  count "and a third" 3 (rays [ (1., glass); through 1.6 ]);
  count "without weight none" 0 (rays [ (0., glass) ])

(* An only ray keeps its share, however little it weighs: a periscope of two
   mirrors of a thousandth each. *)
let test_only_ray () =
  let dim = Surface.mixed [ (1e-3, Surface.reflective) ] in
  check "a millionth of what is bright" (rgb 8. 4. 0.)
    (color
       [
         plane (v 0. 0. 4.) (v 0. 1. (-1.)) dim;
         plane (v 0. 6. 4.) (v 0. (-1.) 1.) dim;
         plane (v 0. 0. 8.) (v 0. 0. 1.) (Surface.luminous (rgb 8e6 4e6 0.));
       ])

(* The upper half of what is far away is red, the lower one blue. *)
let halves =
  let half low high c =
    box (v (-90.) low 20.) (v 90. high 21.) (Surface.luminous c)
  in
  [ half 0. 90. Color.red; half (-90.) 0. Color.blue ]

let above_the_middle objects =
  let prepared =
    Prepared.make
      (Scene.make (camera ()) ~ray_depth:10 ~objects:(objects @ halves))
  in
  let { Color.r; b; _ } =
    Tracer.color prepared (ray (v 0. 0.3 (-1.)) (v 0. 0. 1.))
  in
  if r > 0.8 then "above" else if b > 0.8 then "below" else "neither"

let test_balls () =
  let ball r = sphere (v 0. 0. 5.) r glass in
  let hollow =
    Object.solid
      (Combined (Difference, [ Member (ball 1.); Member (ball 0.95) ]))
  in
  let check = Alcotest.(check string) in
  check "nothing in between" "above" (above_the_middle []);
  check "a glass ball" "below" (above_the_middle [ ball 1. ]);
  check "a hollow one" "above" (above_the_middle [ hollow ]);
  check "a ball of index 1" "above"
    (above_the_middle
       [ sphere (v 0. 0. 5.) 1. (Surface.glass ~index:1. white) ])

let suite =
  ( "Glass",
    [
      Alcotest.test_case "a pane" `Quick test_pane;
      Alcotest.test_case "a block" `Quick test_block;
      Alcotest.test_case "total reflection" `Quick test_total;
      Alcotest.test_case "several rays" `Quick test_several;
      Alcotest.test_case "an only ray" `Quick test_only_ray;
      Alcotest.test_case "balls" `Quick test_balls;
    ] )
