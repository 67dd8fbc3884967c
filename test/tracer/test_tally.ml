open Raylab_scene
open Raylab_tracer
open Test_support
open Build

let show (t : Tally.t) =
  Printf.sprintf "%d primary, %d reflected, %d shadow, %d hits, %d blocked"
    t.primary t.reflected t.shadow t.hits t.blocked

let check what expected ?ray_depth ?lights objects =
  let scene = Scene.make ?ray_depth ?lights ~objects (camera ()) in
  let tally = snd (Render.picture ~domains:1 (Prepared.make scene)) in
  Alcotest.(check string) what expected (show tally)

let wall surface = plane (v 0. 0. 4.) (v 0. 0. 1.) surface
let behind surface = plane (v 0. 0. (-6.)) (v 0. 0. 1.) surface
let white = Surface.diffusive Color.white
let mirror = Surface.reflective

(* One pixel. Only lights that the wall faces are asked for. *)
let test_shadows () =
  let lights =
    [ Shot.sun 0. 0. 1.; Shot.bulb 0. 8. (-4.); Shot.sun 0. 0. (-1.) ]
  in
  check "a miss" "1 primary, 0 reflected, 0 shadow, 0 hits, 0 blocked" ~lights
    [];
  check "two of three lights"
    "1 primary, 0 reflected, 2 shadow, 1 hits, 0 blocked" ~lights
    [ wall white ];
  check "one of them blocked"
    "1 primary, 0 reflected, 2 shadow, 1 hits, 1 blocked" ~lights
    [ wall white; sphere (v 0. 4. 0.) 1. white ];
  check "no light where nothing is returned"
    "1 primary, 0 reflected, 0 shadow, 1 hits, 0 blocked" ~lights
    [ wall (Surface.luminous Color.red) ]

(* Of n rays in a chain n - 1 are mirrored. *)
let test_mirrors () =
  check "to and fro" "1 primary, 3 reflected, 0 shadow, 4 hits, 0 blocked"
    [ wall mirror; behind mirror ];
  check "three rays" "1 primary, 2 reflected, 0 shadow, 3 hits, 0 blocked"
    ~ray_depth:3
    [ wall mirror; behind mirror ];
  check "one ray" "1 primary, 0 reflected, 0 shadow, 1 hits, 0 blocked"
    ~ray_depth:1
    [ wall mirror ];
  check "no ray" "1 primary, 0 reflected, 0 shadow, 0 hits, 0 blocked"
    ~ray_depth:0
    [ wall mirror ];
  check "into the distance"
    "1 primary, 1 reflected, 0 shadow, 1 hits, 0 blocked"
    [ wall mirror ]

let test_sum () =
  let tally a =
    let t = Tally.create () in
    t.primary <- a;
    t.reflected <- 10 * a;
    t.refracted <- 1000 * a;
    t.shadow <- 100 * a;
    t.hits <- 7 * a;
    t.blocked <- 9 * a;
    t
  in
  Alcotest.(check string)
    "each on its own"
    "3 primary, 30 reflected, 300 shadow, 21 hits, 27 blocked"
    (show (Tally.sum [ tally 1; tally 2 ]));
  Alcotest.(check int)
    "refracted" 3000 (Tally.sum [ tally 1; tally 2 ]).refracted;
  Alcotest.(check int) "rays of all kinds" 3333 (Tally.rays (tally 3));
  Alcotest.(check int) "nothing" 0 (Tally.rays (Tally.sum []))

let any_scene =
  Property.holds "consistent, from any number of domains" ~count:100
    ~print:(Property.show Scene.pp)
    (Generate.scene ~max_side:40 Generate.everyday) (fun scene ->
      let prepared = Prepared.make scene in
      let tally domains = snd (Render.picture ~domains prepared) in
      let one = tally 1 in
      let { Camera.width; height; _ } = scene.camera in
      let add sum light = sum + Light.points light in
      let points = List.fold_left add 0 scene.lights in
      let { Film.samples; _ } = scene.film and pixels = width * height in
      pixels <= one.samples
      && one.samples <= samples * pixels
      && one.over_exposed <= pixels && one.samples <= one.primary
      && (samples > 1 || one.primary = pixels)
      && one.blocked <= one.shadow
      && one.hits <= one.primary + one.reflected + one.refracted
      && one.shadow <= one.hits * points
      && show one = show (tally 3))

let suite =
  ( "Tally",
    [
      Alcotest.test_case "shadow rays" `Quick test_shadows;
      Alcotest.test_case "mirrored rays" `Quick test_mirrors;
      Alcotest.test_case "sum" `Quick test_sum;
      any_scene;
    ] )
