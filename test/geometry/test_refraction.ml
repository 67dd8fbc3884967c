open Raylab_geometry
open Test_support
open Build

let up = dir 0. 1. 0.

(* What becomes of a ray along [d] at the origin, where the normal is up. *)
let refraction ~index (d : Direction.t) =
  let spot = Spot.of_point ~point:Vec3.zero ~normal:up ~offset:0. in
  let ray = Ray.to_raw (Ray.make ~origin:Vec3.zero ~direction:d) in
  Spot.turn_to spot ray;
  let refraction = Refraction.create () in
  Refraction.meet refraction spot ray ~index;
  refraction

let direction { Refraction.dx; dy; dz; _ } = v dx dy dz

(* Downwards, so many degrees from the normal. *)
let falling angle =
  let open Raylab_expression.Degrees in
  dir (sin angle) (-.cos angle) 0.

let rising angle =
  let { Vec3.x; y; _ } = (falling angle :> Vec3.t) in
  dir x (-.y) 0.

let near what expected found =
  Alcotest.(check (float 1e-12)) what expected found

let angle { Refraction.cosine; _ } = Raylab_expression.Arc.acos cosine

(* sin 30 = 1.5 sin 19.4712..., and at right angles F = (0.5 / 2.5)^2. *)
let test_glass () =
  let straight = refraction ~index:1.5 (falling 0.) in
  near "straight on" 0. (angle straight);
  near "4 % are mirrored" 0.04 straight.share;
  Alcotest.check (Same.vec3_near 1e-15) "downwards" (v 0. (-1.) 0.)
    (direction straight);
  let bent = refraction ~index:1.5 (falling 30.) in
  near "bent towards the normal" 19.47122063449069 (angle bent);
  Alcotest.check (Same.vec3_near 1e-15) "in the plane of ray and normal"
    (v (1. /. 3.) (-.sqrt 8. /. 3.) 0.)
    (direction bent);
  let out = refraction ~index:1.5 (rising 19.47122063449069) in
  near "and back" 30. (angle out);
  near "the same share both ways" bent.share out.share

(* From 45 degrees to 30 the two polarisations have (2 - sqrt 3)^2 and its
   square. *)
let test_share () =
  let s = 7. -. (4. *. sqrt 3.) in
  let found = refraction ~index:(sqrt 2.) (falling 45.) in
  near "45 degrees become 30" 30. (angle found);
  near "Fresnel's share" ((s +. (s *. s)) /. 2.) found.share;
  near "from outside"
    ((s +. (s *. s)) /. 2.)
    (Refraction.share_from_outside ~index:(sqrt 2.) (sqrt 0.5))

(* Where the tangent is the index, one polarisation is not mirrored; of the
   other it is the square of (1 - 1.5^2) / (1 + 1.5^2) = -5 / 13. *)
let test_brewster () =
  let angle = Raylab_expression.Arc.atan 1.5 in
  near "Brewster's angle" (25. /. 338.)
    (refraction ~index:1.5 (falling angle)).share

let test_critical () =
  let check what expected d =
    Alcotest.(check bool)
      what expected
      (Refraction.is_total (refraction ~index:2. d))
  in
  check "beyond 30 degrees" true (rising 30.001);
  check "within" false (rising 29.999);
  check "never from outside" false (falling 89.999);
  near "all of it" 1. (refraction ~index:2. (rising 60.)).share;
  let nearly = refraction ~index:2. (rising 29.999999) in
  Alcotest.(check bool)
    "nearly all" true
    (nearly.share > 0.99 && nearly.share < 1.)

let test_none () =
  let d = dir 0.6 (-0.8) 0. in
  let same = refraction ~index:1. d in
  near "nothing is mirrored" 0. same.share;
  Alcotest.check (Same.vec3_near 1e-15) "straight on"
    (d :> Vec3.t)
    (direction same)

(* {1 Any} *)

let any =
  QCheck2.Gen.(
    pair (Generate.direction Generate.everyday) (float_range 0.2 5.))

(* Of what is not totally reflected. *)
let holds name law =
  Property.holds name ~count:1000 any (fun (d, index) ->
      let found = refraction ~index d in
      Refraction.is_total found || law d index found)

let snell =
  holds "Snell's law, in the plane of ray and normal" (fun d index found ->
      let d = (d :> Vec3.t) and d' = direction found in
      let eta = if d.y > 0. then index else 1. /. index in
      let close a b = abs_float (a -. b) < 1e-12 in
      close d'.x (eta *. d.x)
      && close d'.z (eta *. d.z)
      && close (Vec3.length d') 1.
      && (d.y = 0. || d.y *. d'.y > 0.))

let backwards =
  holds "the same way back, with the same share" (fun d index found ->
      let back = Vec3.scale (-1.) (direction found) in
      let returned = refraction ~index (Direction.of_vec3_exn back) in
      let { Vec3.y; _ } = (d :> Vec3.t) in
      (* a ray along the surface comes from no side *)
      abs_float y < 1e-3
      || Vec3.length (Vec3.add (direction returned) (d :> Vec3.t)) < 1e-9
         && abs_float (returned.share -. found.share) < 1e-9)

let finite =
  Property.holds "finite, whatever the index" ~count:1000
    QCheck2.Gen.(
      pair
        (Generate.direction Generate.extreme)
        (Generate.positive Generate.extreme))
    (fun (d, index) ->
      (not (Float.is_finite index && index > 0.))
      ||
      let found = refraction ~index d in
      0. <= found.share && found.share <= 1. && 0. <= found.cosine
      && found.cosine <= 1.
      && (Refraction.is_total found
         || abs_float (Vec3.length (direction found) -. 1.) < 1e-9))

let suite =
  ( "Refraction",
    [
      Alcotest.test_case "glass" `Quick test_glass;
      Alcotest.test_case "share" `Quick test_share;
      Alcotest.test_case "Brewster's angle" `Quick test_brewster;
      Alcotest.test_case "critical angle" `Quick test_critical;
      Alcotest.test_case "index 1" `Quick test_none;
      snell;
      backwards;
      finite;
    ] )
