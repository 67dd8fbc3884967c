open Raylab_geometry
open Raylab_scene
open Raylab_viewer
open Test_support

let v = Vec3.make
let usual = Viewpoint.before_origin 4.

let check what expected (found : Viewpoint.t) =
  Alcotest.check Same.vec3 what expected found.eye

let test_turn () =
  let turn across down = Orbit.turn ~across ~down usual in
  check "no way" (v 0. 0. (-4.)) (turn 0. 0.);
  check "to the right: the eye goes left" (v (-4.) 0. 0.) (turn 0.5 0.);
  check "to the left" (v 4. 0. 0.) (turn (-0.5) 0.);
  check "all around" (v 0. 0. (-4.)) (turn 2. 0.);
  check "down: the eye goes up" (v 0. 2.828 (-2.828)) (turn 0. 0.25);
  check "not beyond what is straight up" (v 0. 3.999 (-0.07)) (turn 0. 5.);
  check "nor down" (v 0. (-3.999) (-0.07)) (turn 0. (-5.))

let test_nearer () =
  check "nearer" (v 0. 0. (-3.2)) (Orbit.nearer 1.25 usual);
  check "farther" (v 0. 0. (-5.)) (Orbit.nearer 0.8 usual);
  let far = Viewpoint.make_exn ~look_at:(v 0. 0. 6.) (v 0. 0. 2.) in
  check "to where it looks" (v 0. 0. 4.) (Orbit.nearer 2. far)

let test_settings () =
  let check what expected viewpoint =
    Alcotest.(check string) what expected (Orbit.settings viewpoint)
  in
  check "the usual one" "eye 0 0 -4   lookAt 0 0 0" usual;
  check "short numbers" "eye -2.351 0 -3.236   lookAt 0 0 0"
    (Orbit.turn ~across:0.2 ~down:0. usual);
  check "up" "eye 0.3 2 1   lookAt 0 0 1.5   up 0 0 1"
    (Viewpoint.make_exn ~look_at:(v 0. 0. 1.5) ~up:(v 0. 0. 1.) (v 0.3 2. 1.))

let drags = QCheck2.Gen.(pair (float_range (-3.) 3.) (float_range (-3.) 3.))

let same_distance =
  Property.holds "a turn keeps point, up and, nearly, the distance"
    QCheck2.Gen.(pair (Generate.viewpoint Generate.everyday) drags)
    (fun (viewpoint, (across, down)) ->
      let turned = Orbit.turn ~across ~down viewpoint in
      let before = Viewpoint.distance viewpoint in
      Vec3.equal turned.look_at viewpoint.look_at
      && Vec3.equal turned.up viewpoint.up
      && abs_float (Viewpoint.distance turned -. before) < 0.01 *. before)

let opposite =
  Property.holds "a drag there and back is none, nearly"
    QCheck2.Gen.(
      pair (Generate.viewpoint Generate.everyday) (float_range 0. 1.))
    (fun (viewpoint, across) ->
      let there = Orbit.turn ~across ~down:0. viewpoint in
      let back = Orbit.turn ~across:(-.across) ~down:0. there in
      let away = Vec3.length (Vec3.sub back.eye viewpoint.eye) in
      away < 0.02 *. Viewpoint.distance viewpoint)

let hostile =
  Property.holds "any viewpoint, any drag"
    QCheck2.Gen.(pair (Generate.viewpoint Generate.extreme) drags)
    (fun (viewpoint, (across, down)) ->
      List.for_all
        (fun (moved : Viewpoint.t) -> Vec3.is_finite moved.eye)
        [
          Orbit.turn ~across ~down viewpoint;
          Orbit.nearer 1.25 viewpoint;
          Orbit.nearer 0.8 viewpoint;
        ])

let suite =
  ( "Orbit",
    [
      Alcotest.test_case "turns" `Quick test_turn;
      Alcotest.test_case "nearer" `Quick test_nearer;
      Alcotest.test_case "settings" `Quick test_settings;
      same_distance;
      opposite;
      hostile;
    ] )
