open Raylab_geometry
open Raylab_scene
open Test_support

let any_pixel =
  QCheck2.Gen.(pair (0 -- Camera.max_size) (0 -- Camera.max_size))

let points (x, y) count =
  let pixel = Spread.of_pixel ~x ~y in
  List.init count (fun k -> (Spread.across pixel k, Spread.down pixel k))

(* In whichever way a square is cut into 2^n equal boxes. *)
let are_apart n points =
  let box (across, down) (x, y) =
    (int_of_float (x *. float across), int_of_float (y *. float down))
  in
  let cuts = List.init (n + 1) (fun i -> (1 lsl i, 1 lsl (n - i))) in
  List.for_all
    (fun cut ->
      let boxes = List.map (box cut) points in
      List.compare_lengths points (List.sort_uniq compare boxes) = 0)
    cuts

let spread =
  Property.holds "2^n samples are in as many boxes" any_pixel (fun pixel ->
      List.for_all
        (fun n -> are_apart n (List.tl (points pixel (1 lsl n))))
        [ 1; 2; 3; 4; 5; 6 ])

(* It is itself on the corner of four boxes, and has one of them as long as
   these are not too small. *)
let centre =
  Property.holds "so is the centre" any_pixel (fun pixel ->
      let boxes = [ (0.5, 0.5); (0.499, 0.499); (0.499, 0.5); (0.5, 0.499) ] in
      let fits n centre =
        are_apart n (centre :: List.tl (points pixel (1 lsl n)))
      in
      List.for_all (fun n -> List.exists (fits n) boxes) [ 1; 2; 3; 4 ])

let inside =
  Property.holds "between 0 and 1"
    QCheck2.Gen.(pair any_pixel (0 -- 4095))
    (fun ((x, y), k) ->
      let pixel = Spread.of_pixel ~x ~y in
      let is_inside v = 0. < v && v < 1. in
      List.for_all
        (fun of_ -> is_inside (of_ pixel k))
        [ Spread.across; Spread.down; Spread.lens; Spread.lens' ]
      && Float.is_integer (Spread.seed pixel k)
      && 1. <= Spread.seed pixel k
      && Spread.seed pixel k <= 0x1p30)

(* The same numbers everywhere, as they were on the day they were made. *)
let test_fixed () =
  let pixel = Spread.of_pixel ~x:320 ~y:240 in
  let check what expected of_ =
    Alcotest.(check (list (float 0.)))
      what expected
      (List.map (of_ pixel) [ 0; 1; 2; 4095 ])
  in
  check "across"
    [ 0.5; 0.94405364990234375; 0.19405364990234375; 0.55611419677734375 ]
    Spread.across;
  check "down"
    [ 0.5; 0.97563934326171875; 0.72563934326171875; 0.40947723388671875 ]
    Spread.down;
  check "lens"
    [
      0.10066986083984375;
      0.60066986083984375;
      0.85066986083984375;
      0.09944915771484375;
    ]
    Spread.lens;
  check "lens'"
    [
      0.99681854248046875;
      0.49681854248046875;
      0.24681854248046875;
      0.19091033935546875;
    ]
    Spread.lens';
  check "seed" [ 81193939.; 485301638.; 117364619.; 868956447. ] Spread.seed

(* {1 The rays} *)

let scene lens =
  Scene.make ~lens ~film:(Film.make ~samples:16 ())
    (Build.camera ~width:8 ~height:6 ~canvas_width:4. ~canvas_height:3.
       ~depth:2. ())

let test_centre () =
  let scene = scene Lens.pinhole in
  let ray = Sample_ray.make scene ~x:3 ~y:2 0 in
  Alcotest.check (Same.ray_near 0.) "the primary ray"
    (Camera.primary_ray scene.camera ~x:3 ~y:2)
    ray;
  Alcotest.(check bool) "with a seed" true (Ray.seed ray > 0.)

let focus =
  Property.holds "a lens meets its pinhole in the plane in focus"
    QCheck2.Gen.(quad (0 -- 7) (0 -- 5) (0 -- 15) (float_range 0.1 9.))
    (fun (x, y, k, focus) ->
      let aperture = 0.3 in
      let through lens = Sample_ray.make (scene lens) ~x ~y k in
      let pinhole = through Lens.pinhole
      and ray = through (Lens.make ~focus aperture) in
      (* the plane is at z = focus - 2 *)
      let at_plane ray =
        let d = (Ray.direction ray :> Vec3.t) in
        Ray.at ray ((focus -. 2. -. (Ray.origin ray).z) /. d.z)
      in
      let way = Vec3.sub (Ray.origin ray) (Ray.origin pinhole) in
      Vec3.length (Vec3.sub (at_plane ray) (at_plane pinhole)) < 1e-9
      && abs_float way.z < 1e-12
      && Vec3.length way <= aperture)

let suite =
  ( "Spread",
    [
      spread;
      centre;
      inside;
      Alcotest.test_case "fixed" `Quick test_fixed;
      Alcotest.test_case "the centre" `Quick test_centre;
      focus;
    ] )
