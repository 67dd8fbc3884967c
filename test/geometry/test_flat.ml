(* Discs, triangles and quads. *)

open Raylab_geometry
open Test_support
open Build

let disc = Shape.disc ~centre:(v 1. 0. 5.) ~normal:(v 0. 0. 2.) ~radius:2.
let triangle = Shape.triangle (v 0. 0. 5.) (v 4. 0. 5.) (v 0. 4. 5.)

let quad =
  Shape.quad ~corner:(v 0. 0. 5.) ~edge:(v 4. 0. 0.) ~other:(v 2. 2. 0.)

let along_z x y = ray (v x y 0.) (v 0. 0. 1.)

(* A line goes in and out at once. *)
let check shape what expected ray =
  Alcotest.(check (list (triple (Same.near 1e-14) int bool)))
    what
    (match expected with
    | None -> []
    | Some t -> [ (t, 0, true); (t, 0, false) ])
    (Ask.crossings shape ray)

let test_disc () =
  let check = check disc in
  check "met" (Some 5.) (along_z 1. 1.9);
  check "from behind" (Some 3.) (ray (v 1. 0. 8.) (v 0. 0. (-1.)));
  check "behind" (Some (-5.)) (ray (v 1. 0. 0.) (v 0. 0. (-1.)));
  check "beside" None (along_z 1. 2.1);
  check "the rim is not part of it" None (along_z 3. 0.);
  check "along it" None (ray (v (-5.) 0. 5.) (v 1. 0. 0.))

let test_triangle () =
  let check = check triangle in
  check "met" (Some 5.) (along_z 1. 1.);
  check "from behind" (Some 3.) (ray (v 1. 1. 8.) (v 0. 0. (-1.)));
  check "beyond an edge" None (along_z 2.1 2.1);
  check "the edge is part of it" (Some 5.) (along_z 2. 2.);
  check "and a corner" (Some 5.) (along_z 0. 0.);
  check "along it" None (ray (v (-5.) 1. 5.) (v 1. 0. 0.))

let test_quad () =
  let check = check quad in
  check "met" (Some 5.) (along_z 3. 1.);
  check "from behind" (Some 3.) (ray (v 3. 1. 8.) (v 0. 0. (-1.)));
  check "left of the slanted edge" None (along_z 0.9 1.);
  check "right of the other" None (along_z 5.1 1.);
  check "above" None (along_z 3. 2.1);
  check "a corner" (Some 5.) (along_z 6. 2.)

(* Outward is the direction of (b - a) x (c - a), of the first edge x the
   second, and as given. *)
let test_settle () =
  let settled what normal shape =
    let spot = Ask.spot shape ~reach:5.1 (ray (v 1. 1. 0.) (v 0.1 0. 1.)) in
    Alcotest.check Same.number (what ^ ": its own z") 5. (Spot.own spot).z;
    Alcotest.check Same.number (what ^ ": z") 5. (Spot.point spot).z;
    Alcotest.check Same.direction what normal (Spot.normal spot)
  in
  settled "disc" (dir 0. 0. 1.) disc;
  settled "triangle" (dir 0. 0. 1.) triangle;
  settled "the other way round" (dir 0. 0. (-1.))
    (Shape.triangle (v 0. 0. 5.) (v 0. 4. 5.) (v 4. 0. 5.));
  settled "quad" (dir 0. 0. 1.) quad

(* No line passes between two triangles or quads that share an edge: lines
   through points of the edge, which rounding moves to one side or the other. *)
let no_gap =
  let point = Generate.vec3 Generate.everyday in
  Property.holds "what shares an edge leaves no gap" ~count:5000
    QCheck2.Gen.(
      pair (quad point point point point) (pair (float_range 0. 1.) point))
    (fun ((a, b, c, d), (along, from)) ->
      let on_edge = Vec3.add a (Vec3.scale along (Vec3.sub b a)) in
      match
        ( Direction.of_vec3 (Vec3.sub on_edge from),
          Shape.triangle a b c,
          Shape.triangle b a d )
      with
      | None, _, _ -> true
      | exception Invalid_argument _ -> true
      | Some direction, one, other ->
          let ray = Ray.make ~origin:from ~direction in
          let n = (direction :> Vec3.t) in
          let aside p =
            Vec3.dot (Vec3.cross (Vec3.sub b a) n) (Vec3.sub p a)
          in
          (* on one side of the edge only, both may lie beside the line *)
          aside c *. aside d > -1.
          || Shape.crossings one ray <> []
          || Shape.crossings other ray <> [])

let test_size () =
  List.iter
    (fun k ->
      let at x y = v (k *. x) (k *. y) (5. *. k) in
      let check what shape =
        Alcotest.(check (option (Same.near (1e-14 *. k))))
          (Printf.sprintf "%s times %g" what k)
          (Some (5. *. k))
          (Option.map fst
             (Shape.nearest shape (along_z (0.9 *. k) (0.9 *. k))))
      in
      check "disc"
        (Shape.disc ~centre:(at 1. 0.) ~normal:(v 0. 0. 1.) ~radius:(2. *. k));
      check "triangle" (Shape.triangle (at 0. 0.) (at 4. 0.) (at 0. 4.));
      check "quad"
        (Shape.quad ~corner:(at 0. 0.)
           ~edge:(v (4. *. k) 0. 0.)
           ~other:(v 0. (2. *. k) 0.)))
    [ 1e-9; 1e-3; 1e9; 1e50 ]

let test_mirrored () =
  let mirror = Change.of_modifiers [ Stretched (v (-1.) 1. 1.) ] in
  let check what shape point =
    Alcotest.check Same.direction what (dir 0. 0. 1.)
      (Shape.normal (Shape.transformed mirror shape) point)
  in
  check "triangle" triangle (v (-1.) 1. 5.);
  check "quad" quad (v (-3.) 1. 5.);
  check "disc" disc (v (-1.) 0. 5.)

let test_told () =
  Expect.prints "disc" "disc centre (1, 0, 5) normal (0, 0, 1) radius 2"
    Shape.pp disc;
  Expect.prints "triangle" "triangle a (0, 0, 5) b (4, 0, 5) c (0, 4, 5)"
    Shape.pp triangle;
  Expect.prints "quad" "quad corner (0, 0, 5) edges (4, 0, 0) and (2, 2, 0)"
    Shape.pp quad;
  let same what a b =
    Alcotest.(check bool) what true (Shape.place a = Shape.place b)
  in
  same "whichever corner comes first" triangle
    (Shape.triangle (v 4. 0. 5.) (v 0. 0. 5.) (v 0. 4. 5.));
  same "or edge" quad
    (Shape.quad ~corner:(v 6. 2. 5.) ~edge:(v (-2.) (-2.) 0.)
       ~other:(v (-4.) 0. 0.));
  same "or side" disc
    (Shape.disc ~centre:(v 1. 0. 5.) ~normal:(v 0. 0. (-1.)) ~radius:2.)

let test_invalid () =
  let o = Vec3.zero in
  Expect.invalid "a disc of no radius" (fun () ->
      Shape.disc ~centre:o ~normal:(v 0. 1. 0.) ~radius:0.);
  Expect.invalid "a disc of no normal" (fun () ->
      Shape.disc ~centre:o ~normal:o ~radius:1.);
  Expect.invalid "corners on a line" (fun () ->
      Shape.triangle (v 0.1 0.2 0.3) (v 0.2 0.4 0.6) (v 0.3 0.6 0.9));
  Expect.invalid "two corners alike" (fun () ->
      Shape.triangle o (v 1. 0. 0.) o);
  Expect.invalid "parallel edges" (fun () ->
      Shape.quad ~corner:o ~edge:(v 1. 2. 3.) ~other:(v (-0.1) (-0.2) (-0.3)));
  Expect.invalid "NaN" (fun () ->
      Shape.quad ~corner:o ~edge:(v 1. nan 3.) ~other:(v 1. 0. 0.))

let suite =
  ( "Flat",
    [
      Alcotest.test_case "disc" `Quick test_disc;
      Alcotest.test_case "triangle" `Quick test_triangle;
      Alcotest.test_case "quad" `Quick test_quad;
      Alcotest.test_case "settle" `Quick test_settle;
      no_gap;
      Alcotest.test_case "any size" `Quick test_size;
      Alcotest.test_case "mirrored" `Quick test_mirrored;
      Alcotest.test_case "told" `Quick test_told;
      Alcotest.test_case "invalid" `Quick test_invalid;
    ] )
