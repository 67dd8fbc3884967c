(* No number of a picture or an explanation is infinite or NaN, whatever the
   numbers of the scene; and what an explanation names is there. *)

open Raylab_scene
open Raylab_tracer
open Test_support
open Build
open Fuzz_support

let is_finite scene =
  let prepared = Prepared.make scene in
  let { Camera.width; height; _ } = scene.Scene.camera in
  let pixels =
    Seq.product (Seq.take width (Seq.ints 0)) (Seq.take height (Seq.ints 0))
  in
  Seq.for_all
    (fun (x, y) ->
      let color = Tracer.pixel prepared ~x ~y
      and explanation = Explain.pixel prepared ~x ~y in
      Finite.color color
      && Finite.explanation explanation
      && Color.equal color explanation.color)
    pixels

let holds name number =
  Property.holds name ~count:1000 ~print:(Property.show Scene.pp)
    (Generate.scene ~max_side:4 number)
    is_finite

(* From 1e-150 to 1e150, of either sign. *)
let any_scale =
  QCheck2.Gen.(
    map2
      (fun power sign -> if sign then 10. ** power else -.(10. ** power))
      (float_range (-150.) 150.) bool)

(* Few places, so that spheres coincide and nest, planes go through the eye at
   (0, 0, -1), and lights lie on surfaces and in the eye. *)
let few = QCheck2.Gen.oneofl [ 0.; 1.; -1.; 2.; 0.5; 1e-9; 1e9 ]
let check what scene = Alcotest.(check bool) what true (is_finite scene)

(* {1 One place after another where doubles end} *)

let bulb position = Light.spherical ~intensity:1. ~color:Color.white ~position

let matt =
  Surface.mixed
    [ (1., Surface.diffusive Color.white); (1., Surface.reflective) ]

let scene ?(depth = 1.) light objects =
  Scene.make (camera ~width:3 ~height:3 ~depth ()) ~lights:[ light ] ~objects

let test_ends () =
  let eye = v 0. 0. (-1.) and axis = v 0. 0. 1. in
  check "a sphere around the eye" (scene (bulb eye) [ sphere eye 5. matt ]);
  check "a light on a sphere"
    (scene (bulb (v 0. 0. 4.)) [ sphere eye 5. matt ]);
  check "a plane through the eye" (scene (bulb eye) [ plane eye axis matt ]);
  check "a light in a far plane"
    (scene (bulb (v 0. 0. 1e300)) [ plane (v 0. 0. 1e300) axis matt ]);
  check "a light beyond squares"
    (scene (bulb (v 0. 1e200 0.)) [ sphere (v 0. 0. 4.) 1. matt ]);
  check "a sphere beyond squares"
    (scene (bulb eye) [ sphere (v 1e154 0. 0.) 1e154 matt ]);
  check "an eye beyond squares"
    (scene ~depth:1e308 (bulb (v 0. 0. 0.)) [ plane (v 0. 0. 1.) axis matt ]);
  check "a point beyond doubles"
    (scene ~depth:max_float
       (bulb (v 0. 0. 0.))
       [ plane (v max_float 0. max_float) (v 1. 1. 1.) matt ]);
  (* mirrored by the far wall, the rays at the sides meet the near one there *)
  check "a mirrored point beyond doubles"
    (scene
       (bulb (v 0. 0. 0.))
       [
         plane (v 0. 0. (0.8 *. max_float)) axis matt;
         plane (v 0. 0. (-2.)) axis matt;
       ]);
  check "the smallest sphere"
    (scene (bulb eye) [ sphere (v 0. 0. 0.) 5e-324 matt ])

(* {1 What blocks} *)

(* The question whether something blocks must leave the shadow ray fit for
   the question what. *)
let test_blocker () =
  let wall = plane (v 0. 0. 4.) (v 0. 0. 1.) (Surface.diffusive Color.white) in
  let explain blocker =
    let light = bulb (v 0. 8. (-4.)) in
    Explain.pixel
      (Prepared.make
         (Scene.make (camera ()) ~lights:[ light ] ~objects:[ wall; blocker ]))
      ~x:0 ~y:0
    |> Explain.centre
  in
  let check what blocker =
    match (explain blocker).outcome with
    | Hit { lights = [ { verdict = Blocked { by; t; _ }; _ } ]; _ } ->
        Alcotest.(check int) what 2 by;
        Alcotest.(check bool) "before the light" true (0. < t && t < sqrt 128.)
    | _ -> Alcotest.failf "%s: not blocked" what
  in
  check "a sphere" (sphere (v 0. 4. 0.) 1. matt);
  check "a plane" (plane (v 0. 4. 0.) (v 0. 1. 0.) matt)

(* Numbers are not counted off in lists. *)
let test_many_lights () =
  let lights = List.init 100_000 (fun _ -> bulb (v 0. 1. 0.)) in
  let objects = [ plane (v 0. 0. 4.) (v 0. 0. 1.) matt ] in
  match
    (Explain.centre
       (Explain.pixel
          (Prepared.make (Scene.make (camera ()) ~lights ~objects))
          ~x:0 ~y:0))
      .outcome
  with
  | Hit { lights; _ } ->
      Alcotest.(check (list int))
        "in order" (List.init 100_000 succ)
        (List.map (fun (l : Explain.light) -> l.number) lights)
  | _ -> Alcotest.fail "no hit"

let suite =
  ( "Finite",
    [
      holds "everyday numbers" Generate.everyday;
      holds "from 1e-150 to 1e150" any_scale;
      holds "few numbers, much coincides" few;
      holds "numbers of any size" Generate.extreme;
      Alcotest.test_case "where doubles end" `Quick test_ends;
      Alcotest.test_case "what blocks" `Quick test_blocker;
      Alcotest.test_case "many lights" `Quick test_many_lights;
    ] )
