open Raylab_geometry
open Test_support
open Build

let rotated axis angle =
  let open Raylab_expression in
  Change.Rotated
    { axis; angle; sin = Degrees.sin angle; cos = Degrees.cos angle }

let unit_ball = Shape.sphere ~centre:Vec3.zero ~radius:1.

let changed shape modifiers =
  Shape.transformed (Change.of_modifiers modifiers) shape

let stretched x y z = Change.Stretched (v x y z)

(* {1 By hand} *)

(* x^2 / 4 + y^2 + z^2 = 1. In its point (sqrt 2, sqrt 1/2, 0) the gradient is
   (x / 2, 2 y, 0) = (sqrt 1/2, sqrt 2, 0). *)
let test_ellipsoid () =
  let ellipsoid = changed unit_ball [ stretched 2. 1. 1. ] in
  let meets what expected origin direction =
    Alcotest.(check (list (Same.near 1e-14)))
      what expected
      (Shape.intersections ellipsoid (ray origin direction))
  in
  meets "along x" [ 3.; 7. ] (v (-5.) 0. 0.) (v 1. 0. 0.);
  meets "along y" [ 4.; 6. ] (v 0. (-5.) 0.) (v 0. 3. 0.);
  meets "beside it" [] (v (-5.) 1.1 0.) (v 1. 0. 0.);
  meets "from inside" [ -2.; 2. ] Vec3.zero (v 1. 0. 0.);
  let half = sqrt 0.5 in
  Alcotest.check
    (Same.direction_near 1e-14)
    "its normal"
    (dir half (2. *. half) 0.)
    (Shape.normal ellipsoid (v (2. *. half) half 0.));
  Alcotest.(check string) "name" "sphere" (Shape.name ellipsoid);
  Expect.prints "pp" "sphere centre (0, 0, 0) radius 1 stretched 2 1 1"
    Shape.pp ellipsoid

(* A ball around (1, 0, 0) becomes one around (-1, 0, 0), with its inside
   inside. *)
let test_mirrored () =
  let ball = Shape.sphere ~centre:(v 1. 0. 0.) ~radius:0.5 in
  let mirrored = changed ball [ stretched (-1.) 1. 1. ] in
  let from_left = ray (v (-5.) 0. 0.) (v 1. 0. 0.) in
  Alcotest.(check (list (triple (Same.near 1e-14) int bool)))
    "in and out"
    [ (3.5, 0, true); (4.5, 0, false) ]
    (Ask.crossings mirrored from_left);
  Alcotest.check
    (Same.direction_near 1e-14)
    "outward" (dir (-1.) 0. 0.)
    (Shape.normal mirrored (v (-1.5) 0. 0.));
  Alcotest.check (Same.near 1e-14) "deep inside" 0.5
    (Shape.depth mirrored (v (-1.) 0. 0.) *. sqrt 3.);
  let floor = Shape.plane ~point:Vec3.zero ~normal:(v 1. 1. 0.) in
  Alcotest.check
    (Same.direction_near 1e-14)
    "a plane's side" (dir (-1.) 1. 0.)
    (Shape.normal (changed floor [ stretched (-1.) 1. 1. ]) Vec3.zero)

(* A quarter turn, with the left thumb along z, takes x to y. *)
let test_kinds () =
  let ball = Shape.sphere ~centre:(v 1. 0. 0.) ~radius:0.5 in
  let is what expected shape =
    Alcotest.(check bool) what true (Shape.equal expected shape)
  in
  let baked =
    changed ball
      [ Scaled 2.; rotated (dir 0. 0. 1.) 90.; Translated (v 0. 0. 1.) ]
  in
  is "stays a ball" (Shape.sphere ~centre:(v 0. 2. 1.) ~radius:1.) baked;
  is "equal factors"
    (Shape.sphere ~centre:(v 3. 0. 0.) ~radius:1.5)
    (changed ball [ stretched 3. 3. 3. ]);
  is "a plane stays one"
    (Shape.plane ~point:(v 2. 0. 0.) ~normal:(v 1. 2. 0.))
    (changed
       (Shape.plane ~point:(v 1. 0. 0.) ~normal:(v 1. 1. 0.))
       [ stretched 2. 1. 1. ]);
  is "one change after the other"
    (changed ball [ stretched 1. 2. 1.; Translated (v 1. 1. 1.) ])
    (changed (changed ball [ stretched 1. 2. 1. ]) [ Translated (v 1. 1. 1.) ])

(* A pattern goes with its object: the own point is that before the change. *)
let test_own () =
  let ball = Shape.sphere ~centre:(v 1. 0. 0.) ~radius:1. in
  let own ?keep_own change =
    let shape = Shape.transformed ?keep_own change ball in
    let down = ray (v 0. 9. 0.) (v 0. (-1.) 0.) in
    match Shape.nearest shape down with
    | None -> Alcotest.fail "nothing is met"
    | Some (reach, _) -> Spot.own (Ask.spot shape ~reach down)
  in
  let stretch =
    Change.of_modifiers [ Translated (v (-1.) 0. 0.); stretched 1. 5. 1. ]
  in
  let move = Change.of_modifiers [ Translated (v (-1.) 0. 0.) ] in
  let check = Alcotest.check (Same.vec3_near 1e-14) in
  check "stretched" (v 1. 1. 0.) (own stretch);
  check "moved" (v 0. 1. 0.) (own move);
  check "moved, with its coordinates" (v 1. 1. 0.) (own ~keep_own:true move);
  let unchanged = Shape.transformed ~keep_own:true Change.identity ball in
  Alcotest.(check int) "not at all" 0 (List.length (Shape.modifiers unchanged));
  Alcotest.(check bool) "and equal" true (Shape.equal ball unchanged)

(* What went into the point: 1000 along x, and a radius of 1. *)
let test_size () =
  let far =
    changed unit_ball [ stretched 1. 2. 1.; Translated (v 1e3 0. 0.) ]
  in
  let spot = Ask.spot far ~reach:9. (ray (v 990. 0. 0.) (v 1. 0. 0.)) in
  Alcotest.(check bool) "at least" true (spot.size >= 1001.)

let test_refused () =
  let refused what modifiers =
    Expect.invalid what (fun () -> changed unit_ball modifiers)
  in
  refused "a factor of 0" [ stretched 1. 0. 1. ];
  refused "scaled by nothing" [ Scaled 0. ];
  refused "no number" [ Translated (v nan 0. 0.) ];
  refused "too large" [ stretched 1e200 1. 1.; stretched 1e200 1. 1. ];
  refused "too small" [ stretched 1e-200 1. 1.; stretched 1e-200 1. 1. ];
  refused "too far away"
    [
      stretched 1. 2. 1.;
      Translated (v max_float 0. 0.);
      Translated (v max_float 0. 0.);
    ]

(* {1 Properties} *)

let inverse =
  Property.holds "the inverse undoes a change"
    QCheck2.Gen.(
      pair
        (Generate.change Generate.everyday)
        (Generate.vec3 Generate.everyday))
    (fun (change, p) ->
      let out = Change.affine change in
      let back = Option.get (Affine.inverse out) in
      let there = Affine.point out p in
      Vec3.length (Vec3.sub p (Affine.point back there))
      <= 1e-12
         *. (1. +. Vec3.length p
            +. (Affine.size back *. (10. +. Vec3.length there))))

(* The crossings of a changed shape are where those of the own one go. *)
let crossings =
  Property.holds "crossings go where their points go" ~count:2000
    QCheck2.Gen.(
      triple
        (Generate.simple_shape Generate.everyday)
        (Generate.change Generate.everyday)
        (Generate.ray Generate.everyday))
    (fun (own, change, r) ->
      let out = Change.affine change in
      let there =
        Ray.make
          ~origin:(Affine.point out (Ray.origin r))
          ~direction:
            (Direction.of_vec3_exn
               (Affine.vector out (Ray.direction r :> Vec3.t)))
      and length =
        Vec3.length (Affine.vector out (Ray.direction r :> Vec3.t))
      in
      let same (t, part, enters) (t', part', enters') =
        part = part' && enters = enters'
        && abs_float ((t *. length) -. t') <= 1e-5 *. (1. +. abs_float t')
      in
      let a = Ask.crossings own r
      and b = Ask.crossings (Shape.transformed change own) there in
      (* a ray that barely touches a ball may miss it after rounding *)
      match a with
      | [ (t, _, _); (t', _, _) ] when t' -. t < 1e-4 -> true
      | _ -> List.equal same a b)

let suite =
  ( "Placed",
    [
      Alcotest.test_case "ellipsoid" `Quick test_ellipsoid;
      Alcotest.test_case "mirrored" `Quick test_mirrored;
      Alcotest.test_case "kinds" `Quick test_kinds;
      Alcotest.test_case "own point" `Quick test_own;
      Alcotest.test_case "size" `Quick test_size;
      Alcotest.test_case "refused" `Quick test_refused;
      inverse;
      crossings;
    ] )
