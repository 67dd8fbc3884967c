open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Test_support
open Build

(* The nearest hit in a scene whose canvas and depth are [k] times 2 x 2 and
   1. *)
let hit ?(k = 1.) objects ray =
  let camera =
    camera ~canvas_width:(2. *. k) ~canvas_height:(2. *. k) ~depth:k ()
  in
  Tracer.nearest_hit (Prepared.make (Scene.make ~objects camera)) ray

let ball = sphere (v 0. 0. 5.) 1. Surface.reflective
let wall z = plane (v 0. 0. z) (v 0. 0. 1.) Surface.reflective
let floor = plane (v 0. (-1.) 0.) (v 0. 1. 0.) Surface.reflective
let z_axis = ray Vec3.zero (v 0. 0. 1.)

let check what ~t ~point ~normal ~outside objects ray =
  let found = Option.get (hit objects ray) in
  Alcotest.check (Same.near 1e-14) (what ^ ", t") t found.t;
  Alcotest.check (Same.vec3_near 1e-14) (what ^ ", point") point found.point;
  Alcotest.check
    (Same.direction_near 1e-14)
    (what ^ ", normal") normal found.normal;
  Alcotest.(check bool) (what ^ ", outside") outside found.outside;
  Alcotest.(check int) (what ^ ", its only part") 0 found.part

(* The normal is on the side that the ray comes from. *)
let test_sides () =
  check "from outside" ~t:4. ~point:(v 0. 0. 4.) ~normal:(dir 0. 0. (-1.))
    ~outside:true [ ball ] z_axis;
  check "from inside" ~t:1. ~point:(v 0. 0. 6.) ~normal:(dir 0. 0. (-1.))
    ~outside:false [ ball ]
    (ray (v 0. 0. 5.) (v 0. 0. 1.));
  check "from above" ~t:1. ~point:(v 0. (-1.) 0.) ~normal:(dir 0. 1. 0.)
    ~outside:true [ floor ]
    (ray Vec3.zero (v 0. (-1.) 0.));
  check "from below" ~t:1. ~point:(v 0. (-1.) 0.) ~normal:(dir 0. (-1.) 0.)
    ~outside:false [ floor ]
    (ray (v 0. (-2.) 0.) (v 0. 1. 0.))

let at_its_place (shape : Shape.t) own_point =
  match shape with
  | Placed { out; _ } -> Affine.point out own_point
  | _ -> own_point

(* Beside the point by rounding alone, and on the plane by nothing. *)
let own_point =
  Property.holds "an own point is the point, as exactly on the shape as can be"
    QCheck2.Gen.(
      pair
        (Generate.changed_shape Generate.everyday)
        (Generate.ray Generate.everyday))
    (fun (shape, ray) ->
      match hit [ Object.make shape Surface.reflective ] ray with
      | None -> true
      | Some { t; point; own_point; _ } ->
          let here = at_its_place shape own_point in
          Vec3.length (Vec3.sub point here)
          <= 1e-13 *. (30. +. Vec3.magnitude own_point +. t))

let finite =
  Property.holds "finite, whatever the numbers" ~count:5000
    QCheck2.Gen.(
      pair
        (Generate.changed_shape Generate.extreme)
        (Generate.ray Generate.extreme))
    (fun (shape, ray) ->
      match hit [ Object.make shape Surface.reflective ] ray with
      | None -> true
      | Some ({ t; point; own_point; _ } as found) ->
          Float.is_finite t
          && List.for_all Vec3.is_finite [ point; own_point; Hit.start found ])

let test_own_point () =
  let slab = plane (v 7. 0.1 3.) (v 0. 49. 0.) Surface.reflective in
  List.iter
    (fun x ->
      let found =
        Option.get (hit [ slab ] (ray (v 0. 3. 0.) (v x (-0.7) 1.)))
      in
      Alcotest.check Same.number "exactly at its height" 0.1 found.own_point.y;
      Alcotest.check Same.number "x as it is" found.point.x found.own_point.x;
      Alcotest.check Same.number "z as it is" found.point.z found.own_point.z)
    [ -1. /. 3.; 0.; 0.123; 1. /. 7. ]

let test_which () =
  let check what expected objects =
    Alcotest.(check (option int))
      what expected
      (Option.map (fun (h : Hit.t) -> h.number) (hit objects z_axis))
  in
  check "counted from 1" (Some 1) [ ball ];
  check "none" None [];
  check "the first at the same distance" (Some 1) [ wall 4.; ball ];
  check "in whichever order" (Some 1) [ ball; wall 4. ];
  check "the nearer" (Some 2) [ ball; wall 3.9; wall 4. ]

(* 1e-5 where canvas and depth are about 1, as in the original, and as much of
   the scene's lengths at every other scale. *)
let test_start () =
  List.iter
    (fun k ->
      let ball = sphere (v 0. 0. (5. *. k)) k Surface.reflective in
      let found = Option.get (hit ~k [ ball ] z_axis) in
      let what = Printf.sprintf "scale %g" k in
      Alcotest.check (Same.near (1e-12 *. k)) what (1e-5 *. k) found.offset;
      Alcotest.check
        (Same.vec3_near (1e-12 *. k))
        what
        (v 0. 0. ((4. -. 1e-5) *. k))
        (Hit.start found))
    [ 1e-3; 1.; 1e3 ]

(* Beside numbers of 1e12, whose neighbours are 1e-4 apart, 1e-5 is nothing. *)
let test_large_numbers () =
  let found = Option.get (hit [ wall 1e12 ] z_axis) in
  Alcotest.(check bool)
    "starts before the surface" true
    ((Hit.start found).z < 1e12)

(* The ball hangs 2.5 above the floor at (0, -1, 5). There the sun straight
   above it is hidden. The other comes along (3, -4, 0) / 5; its ray to (0, -1,
   5) passes the centre (0, 1.5, 5) at 2.5 * 0.6 = 1.5, so beside the ball of
   radius 1: 2 * 0.8 is left of both. *)
let test_light () =
  let hanging = sphere (v 0. 1.5 5.) 1. Surface.reflective in
  let scene =
    Scene.make (camera ()) ~objects:[ floor; hanging ]
      ~lights:[ Shot.sun 0. (-1.) 0.; Shot.sun ~intensity:2. 3. (-4.) 0. ]
  in
  let prepared = Prepared.make scene in
  let check what expected x =
    let down = ray (v x 0. 5.) (v 0. (-1.) 0.) in
    let found = Option.get (Tracer.nearest_hit prepared down) in
    Alcotest.check (Same.color_near 1e-12) what (grey expected)
      (Tracer.light prepared found)
  in
  check "1 + 2 * 0.8" 2.6 9.;
  check "one of them" 1.6 0.

let test_pp () =
  Expect.prints "pp" "t = 4 at (0, 0, 4), normal (0, 0, -1)" Hit.pp
    (Option.get (hit [ ball ] z_axis))

let suite =
  ( "Hit",
    [
      Alcotest.test_case "sides" `Quick test_sides;
      Alcotest.test_case "own point" `Quick test_own_point;
      own_point;
      finite;
      Alcotest.test_case "which object" `Quick test_which;
      Alcotest.test_case "start" `Quick test_start;
      Alcotest.test_case "large numbers" `Quick test_large_numbers;
      Alcotest.test_case "light" `Quick test_light;
      Alcotest.test_case "pp" `Quick test_pp;
    ] )
