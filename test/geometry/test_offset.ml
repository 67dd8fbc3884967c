open Raylab_geometry
open Test_support
open Build

(* [lifted ~usual ~size point ~origin] is a spot at [point], of a shape of this
   [size], where a ray from [origin] ends. *)
let lifted ?(usual = 1e-5) ?(size = 0.) point ~origin =
  let spot = Spot.of_point ~point ~normal:(dir 0. 1. 0.) ~offset:nan in
  spot.size <- size;
  Offset.lift ~usual spot (Ray.to_raw (ray origin (v 0. 0. 1.)));
  spot

let check_number = Alcotest.check Same.number

let test_usual () =
  check_number "1e-5 of the scale" 4e-5 (Offset.of_scale 4.);
  check_number "of everyday numbers" 1e-5
    (lifted ~size:5. (v 1. 2. 3.) ~origin:(v 4. 5. 6.)).offset

(* 2^40 times (1 + 2 + 3 + 4 + 5 + 6 + 7), whichever the signs, makes 28 / 16;
   2^-44 of it. *)
let test_large () =
  let k = 0x1p40 in
  let spot =
    lifted ~size:(7. *. k)
      (v k (-2. *. k) (3. *. k))
      ~origin:(v (-4. *. k) (5. *. k) (-6. *. k))
  in
  check_number "of large ones" 1.75 spot.offset;
  Alcotest.check Same.vec3 "the point stays"
    (v k (-2. *. k) (3. *. k))
    (Spot.point spot);
  check_number "the larger of the two" 2.
    (lifted ~usual:2. (v k (-2. *. k) (3. *. k)) ~origin:Vec3.zero).offset;
  check_number "where both are the same" 0.375
    (lifted ~usual:0.375 (v k (-2. *. k) (3. *. k)) ~origin:Vec3.zero).offset

(* 2^1022 is as far out as a point may lie. *)
let test_farthest () =
  let ({ Spot.x; y; z; offset; _ } as spot) =
    lifted ~size:max_float
      (v max_float (-.max_float) 7.)
      ~origin:(v max_float max_float max_float)
  in
  check_number "farthest" (ldexp 1. 1022) Offset.farthest;
  Alcotest.check Same.vec3 "brought in" (v 0x1p1022 (-0x1p1022) 7.) (v x y z);
  Alcotest.check Same.vec3 "its own point, too"
    (v 0x1p1022 (-0x1p1022) 7.)
    (Spot.own spot);
  check_number "the largest offset" (ldexp 1. (1022 - 44)) offset;
  List.iter
    (fun (what, expected, x) -> check_number what expected (Offset.within x))
    [
      ("within", 5., 5.);
      ("at the end", 0x1p1022, 0x1p1022);
      ("beyond", 0x1p1022, Float.succ 0x1p1022);
      ("beyond, negative", -0x1p1022, -.max_float);
      ("infinite", 0x1p1022, infinity);
    ]

(* Whatever the numbers, the start is off the surface and finite, and so is the
   point. *)
let off_the_surface =
  Property.holds "a start is beside its point, and finite" ~count:2000
    QCheck2.Gen.(
      triple
        (Generate.vec3 Generate.extreme)
        (Generate.vec3 Generate.extreme)
        (Generate.positive Generate.extreme))
    (fun (point, origin, size) ->
      let spot = lifted ~size point ~origin in
      let raw = Raw_ray.create () in
      Spot.start spot raw;
      let start = v raw.ox raw.oy raw.oz in
      Float.is_finite spot.offset
      && Vec3.is_finite (Spot.point spot)
      && Vec3.is_finite (Spot.own spot)
      && Vec3.is_finite start && start.y > spot.y)

let suite =
  ( "Offset",
    [
      Alcotest.test_case "usual" `Quick test_usual;
      Alcotest.test_case "large numbers" `Quick test_large;
      Alcotest.test_case "the farthest" `Quick test_farthest;
      off_the_surface;
    ] )
