open Raylab_scene
open Raylab_tracer
open Test_support
open Build

let print = Property.show Scene.pp
let scenes = Generate.scene ~max_side:50 Generate.everyday

let with_samples samples scene =
  Scene.with_film (Film.with_samples samples scene.Scene.film) scene

let coarse_to_fine =
  Property.holds "a picture that is watched becomes the same" ~count:40 ~print
    scenes (fun scene ->
      let prepared = Prepared.make (with_samples 8 scene) in
      let watched = Render.blank prepared in
      ignore
        (Render.refine ~domains:2 watched prepared ~on_tile:(fun _ _ -> ())
          : Tally.t);
      Picture.equal watched (fst (Render.picture ~domains:2 prepared)))

let alone =
  Property.holds "a pixel is the same alone" ~count:40 ~print scenes
    (fun scene ->
      let prepared = Prepared.make (with_samples 8 scene) in
      let picture = fst (Render.picture ~domains:2 prepared) in
      List.for_all
        (fun (x, y) ->
          Picture.get picture ~x ~y
          = Film.to_bytes scene.film (Tracer.pixel prepared ~x ~y))
        (Shot.pixels picture))

(* {1 How many} *)

(* A white wall of which the left half is black, in a picture of 9 pixels a
   row. *)
let taken ?(film = Film.make ~samples:16 ()) x =
  let glow k = Surface.luminous (grey k) in
  let objects =
    [
      plane (v 0. 0. 4.) (v 0. 0. 1.) (glow 0.5);
      plane (v (-0.1) 0. 0.) (v 1. 0. 0.) (glow 0.);
    ]
  in
  let scene = Scene.make ~film ~objects (camera ~width:9 ~height:3 ()) in
  let sampler = Sampler.create (Prepared.make scene) in
  ignore (Sampler.lone_pixel sampler ~x ~y:1 : Color.t);
  (Sampler.taken sampler, Sampler.cause sampler ~x ~y:1)

let test_taken () =
  let check what expected ?film x =
    Alcotest.(check int) what expected (fst (taken ?film x))
  in
  check "in the middle of the white" 1 6;
  check "in the middle of the black" 1 1;
  check "at the edge" 16 4;
  check "beside it, where all 4 are alike" 4 3;
  check "at most 2" ~film:(Film.make ~samples:2 ()) 2 4;
  check "at most 6" ~film:(Film.make ~samples:6 ()) 6 4;
  check "too dark to be seen"
    ~film:(Film.make ~samples:16 ~exposure:0.06 ())
    1 4;
  check "but not by the curve"
    ~film:(Film.make ~samples:16 ~exposure:0.06 ~srgb:true ())
    16 4

let test_cause () =
  match taken 4 with
  | _, Some { x; _ } -> Alcotest.(check int) "the pixel beside it" 3 x
  | _, None -> Alcotest.fail "no cause"

let test_flat () =
  let film = Film.make ~samples:16 () in
  let scene =
    Scene.make ~film ~background:(grey 0.3) (camera ~width:320 ~height:320 ())
  in
  let tally = snd (Render.picture ~domains:1 (Prepared.make scene)) in
  Alcotest.(check int) "one sample a pixel" (320 * 320) tally.samples;
  Alcotest.(check bool)
    "and few rays more" true
    (float_of_int tally.primary < 1.13 *. 320. *. 320.)

(* {1 How good}

   A thousand thin mirrored balls on a floor to the horizon, beside the same
   picture eight times as large. *)

let floor_of_balls =
  let ball k =
    let column = float_of_int ((k mod 25) - 12)
    and row = float_of_int (k / 25)
    and phase n = float_of_int (k * n mod 360) in
    let x = column *. (0.5 +. (row *. 0.04))
    and z = row *. (0.3 +. (row *. 0.03)) in
    sphere (v x (-0.9) z) 0.1
      (Surface.mixed
         [
           (0.2, Surface.diffusive (rgb 1. (phase 50 /. 360.) 0.5));
           (0.8, Surface.reflective);
         ])
  in
  Scene.make ~background:(rgb 0.45 0.6 0.85)
    ~lights:
      [
        Shot.sun ~intensity:0.7 1. (-1.3) 1.2;
        Shot.sun ~intensity:0.25 0. (-1.) 0.2;
      ]
    ~objects:
      (plane (v 0. (-1.) 0.) (v 0. 1. 0.)
         (Surface.diffusive (rgb 0.75 0.7 0.6))
      :: List.init 1000 ball)
    (camera ~width:96 ~height:32 ~canvas_width:4. ~canvas_height:(4. /. 3.)
       ~depth:4. ())

let times = 8

(* The mean difference of a channel, in levels. *)
let difference picture large =
  let filtered x y channel =
    let sum = ref 0 in
    for j = 0 to times - 1 do
      for i = 0 to times - 1 do
        let x = (times * x) + i and y = (times * y) + j in
        sum := !sum + channel (Picture.get large ~x ~y)
      done
    done;
    float_of_int !sum /. float_of_int (times * times)
  in
  let channels =
    [ (fun (r, _, _) -> r); (fun (_, g, _) -> g); (fun (_, _, b) -> b) ]
  in
  let errors =
    List.concat_map
      (fun (x, y) ->
        List.map
          (fun channel ->
            let shown = float_of_int (channel (Picture.get picture ~x ~y)) in
            abs_float (shown -. filtered x y channel))
          channels)
      (Shot.pixels picture)
  in
  List.fold_left ( +. ) 0. errors /. float_of_int (List.length errors)

let test_floor () =
  let { Scene.camera = { width; height; _ } as camera; _ } = floor_of_balls in
  let width = times * width and height = times * height in
  let large = Camera.with_size ~width ~height camera in
  let picture scene = Shot.picture scene in
  let large = picture (Scene.with_camera large floor_of_balls) in
  let error samples =
    difference (picture (with_samples samples floor_of_balls)) large
  in
  let check what truth = Alcotest.(check bool) what true truth in
  check "64 samples: less than 1.5 levels" (error 64 < 1.5);
  check "one: more than 4" (error 1 > 4.)

let suite =
  ( "Sampler",
    [
      coarse_to_fine;
      alone;
      Alcotest.test_case "how many" `Quick test_taken;
      Alcotest.test_case "why" `Quick test_cause;
      Alcotest.test_case "flat" `Quick test_flat;
      Alcotest.test_case "a floor to the horizon" `Quick test_floor;
    ] )
