(* Spots, area lights and lights that do not fade. *)

open Raylab_geometry
open Raylab_scene
open Test_support
open Build

let check_color = Alcotest.check (Same.color_near 1e-14)
let check_number = Alcotest.check (Same.near 1e-14)
let up = dir 0. 1. 0.
let color = rgb 1. 0.5 0.
let received ?seed light = Incidence.received ?seed light ~normal:up

(* {1 Spots} *)

(* From (0, 2, 0) straight down. *)
let spot inner outer =
  Light.spot ~intensity:8. ~color
    (Beam.make_exn ~position:(v 0. 2. 0.) ~target:(v 0. 0. 0.) ~inner ~outer)

(* Straight below: 8 / 2^2 of the colour. At (2, 0, 0) the way makes 45 degrees
   with the axis and with the normal, and is sqrt 8 long: 8 / 8 * cos 45. *)
let test_spot () =
  let below = v 0. 0. 0. and aside = v 2. 0. 0. in
  let half = 1. /. sqrt 2. in
  check_color "on the axis" (rgb 2. 1. 0.)
    (received (spot 0. 20.) ~point:below);
  check_color "within the inner angle"
    (rgb half (half /. 2.) 0.)
    (received (spot 45.0001 50.) ~point:aside);
  check_color "beyond the outer one" Color.black
    (received (spot 20. 44.9999) ~point:aside);
  check_color "a sharp edge, inside"
    (rgb half (half /. 2.) 0.)
    (received (spot 45.0001 45.0001) ~point:aside);
  check_color "a sharp edge, outside" Color.black
    (received (spot 44.9999 44.9999) ~point:aside)

(* cos 45 = 0.70711 between cos 60 = 0.5 and cos 30 = 0.86603: t = 0.56583,
   3 t^2 - 2 t^3 = 0.59817; in the middle between the cosines it is a half. *)
let test_edge () =
  let beam = Beam.make_exn ~position:(v 0. 2. 0.) ~target:Vec3.zero in
  let part ~inner ~outer c = Beam.part (beam ~inner ~outer) c in
  Alcotest.check (Same.near 1e-5) "between" 0.59817
    (part ~inner:30. ~outer:60. (sqrt 0.5));
  check_number "half way" 0.5 (part ~inner:0. ~outer:90. 0.5);
  check_number "at the inner angle" 1. (part ~inner:60. ~outer:90. 0.5);
  check_number "at the outer angle" 0. (part ~inner:30. ~outer:60. 0.5);
  check_number "the angle of a point" 45.
    (Beam.angle (beam ~inner:1. ~outer:2.) (v 2. 0. 0.));
  check_number "behind it" 180.
    (Beam.angle (beam ~inner:1. ~outer:2.) (v 0. 9. 0.))

let test_no_cone () =
  let position = v 0. 2. 0. and target = v 0. 0. 0. in
  let refused what problem ?(position = position) ?(target = target) inner
      outer =
    Alcotest.(check bool)
      what true
      (Beam.make ~position ~target ~inner ~outer = Error problem);
    Expect.invalid what (fun () ->
        Beam.make_exn ~position ~target ~inner ~outer)
  in
  refused "no axis" No_axis ~target:position 10. 20.;
  refused "inner beyond outer" Inner_beyond_outer 20. 10.;
  refused "180" Not_below_180 20. 180.;
  refused "negative" Not_finite (-1.) 20.;
  refused "NaN" Not_finite 1. nan;
  refused "far away" Not_finite ~position:(v 0. infinity 0.) 10. 20.

(* Wherever its cone is, which is all but one degree behind it. *)
let widest =
  Property.holds "a spot of 179 179 is a spherical light" ~count:1000
    QCheck2.Gen.(
      quad
        (Generate.vec3 Generate.everyday)
        (Generate.vec3 Generate.everyday)
        (Generate.vec3 Generate.everyday)
        (Generate.direction Generate.everyday))
    (fun (position, target, point, normal) ->
      match Beam.make ~position ~target ~inner:179. ~outer:179. with
      | Error _ -> true
      | Ok beam ->
          Beam.angle beam point > 178.9
          ||
          let received light = Incidence.received light ~point ~normal in
          let intensity = 3. in
          Color.equal
            (received (Light.spot ~intensity ~color beam))
            (received (Light.spherical ~intensity ~color ~position)))

(* {1 Area lights} *)

let pane count =
  Pane.make ~corner:(v 1. 2. 3.) ~edge:(v 2. 0. 0.) ~other:(v 0. 0. 4.) ~count

let seeds = QCheck2.Gen.(map float_of_int (0 -- 0x40000000))

let in_cells =
  Property.holds "each cell has its point" ~count:1000
    QCheck2.Gen.(pair (1 -- 20) seeds)
    (fun (count, seed) ->
      let pane = pane count in
      let is_in cell x =
        let n = float_of_int count and cell = float_of_int cell in
        cell /. n <= x && x <= (cell +. 1.) /. n
      in
      List.for_all
        (fun k ->
          is_in (k / count) (Pane.across pane k ~seed)
          && is_in (k mod count) (Pane.along pane k ~seed))
        (List.init (Pane.points pane) Fun.id))

(* The first cell of 1 x 1, by many seeds: the mean is the middle, and each
   tenth has a tenth of them. *)
let test_spread () =
  let n = 20_000 in
  let places f = List.init n (fun k -> f (pane 1) 0 ~seed:(float_of_int k)) in
  List.iter
    (fun places ->
      let sum = List.fold_left ( +. ) 0. places in
      Alcotest.check (Same.near 0.01) "mean" 0.5 (sum /. float_of_int n);
      List.iter
        (fun tenth ->
          let is_in x = int_of_float (10. *. x) = tenth in
          Alcotest.check (Same.near 0.01) "a tenth" 0.1
            (float_of_int (List.length (List.filter is_in places))
            /. float_of_int n))
        (List.init 10 Fun.id))
    [ places Pane.across; places Pane.along ]

(* What it gives is the mean of spherical lights at its points. *)
let mean_of_points =
  Property.holds "the mean of its points" ~count:500
    QCheck2.Gen.(triple (1 -- 5) seeds (Generate.vec3 Generate.everyday))
    (fun (count, seed, point) ->
      let ({ Pane.corner; edge; other; _ } as pane) = pane count in
      let gives k =
        let u = Pane.across pane k ~seed and v = Pane.along pane k ~seed in
        let position = Vec3.Infix.(corner + (u * edge) + (v * other)) in
        received (Light.spherical ~intensity:3. ~color ~position) ~point
      in
      let points = List.init (count * count) gives in
      let sum = List.fold_left Color.add Color.black points in
      Alcotest.equal (Same.color_about 1e-12)
        (Color.scale (1. /. float_of_int (count * count)) sum)
        (received ~seed (Light.area ~intensity:3. ~color pane) ~point))

let point_like =
  Property.holds "of size 0 it is a spherical light" ~count:500
    QCheck2.Gen.(
      quad (1 -- 5) seeds
        (Generate.vec3 Generate.everyday)
        (Generate.vec3 Generate.everyday))
    (fun (count, seed, corner, point) ->
      let pane = Pane.make ~corner ~edge:Vec3.zero ~other:Vec3.zero ~count in
      let area = received ~seed (Light.area ~intensity:3. ~color pane) ~point
      and point_light =
        received (Light.spherical ~intensity:3. ~color ~position:corner) ~point
      in
      if count = 1 then Color.equal area point_light
      else Alcotest.equal (Same.color_about 1e-9) area point_light)

let test_no_pane () =
  let make ?(corner = v 0. 2. 0.) ?(edge = v 1. 0. 0.) count () =
    Pane.make ~corner ~edge ~other:(v 0. 0. 1.) ~count
  in
  Expect.invalid "no point" (make 0);
  Expect.invalid "65 points" (make 65);
  Expect.invalid "NaN" (make ~edge:(v nan 0. 0.) 2);
  Expect.invalid "beyond doubles"
    (make ~corner:(v 1e308 0. 0.) ~edge:(v 1e308 0. 0.) 2);
  Alcotest.(check int) "64 x 64" 4096 (Pane.points (make 64 ()))

(* {1 Unfading} *)

(* (3, 4, 0) is 5 from the origin, with a cosine of 4/5. *)
let test_unfading () =
  let bulb = Light.spherical ~intensity:2. ~color ~position:(v 3. 4. 0.) in
  check_color "no fall-off" (rgb 1.6 0.8 0.)
    (received (Light.unfading bulb) ~point:Vec3.zero);
  let sun =
    Light.directional ~intensity:2. ~color ~direction:(v 0. (-1.) 0.)
  in
  check_color "a sun has none" (rgb 2. 1. 0.)
    (received (Light.unfading sun) ~point:Vec3.zero);
  check_color "a spot" (rgb 8. 4. 0.)
    (received (Light.unfading (spot 10. 20.)) ~point:Vec3.zero);
  Alcotest.(check bool)
    "another light" false
    (Light.equal bulb (Light.unfading bulb))

let moved =
  Property.holds "along its way it gives the same everywhere" ~count:500
    QCheck2.Gen.(
      pair (float_range 0.1 100.) (Generate.direction Generate.everyday))
    (fun (k, along) ->
      let at k =
        let position = Vec3.scale k (along :> Vec3.t) in
        Light.unfading (Light.spherical ~intensity:2. ~color ~position)
      in
      Alcotest.equal (Same.color_about 1e-12)
        (received (at 1.) ~point:Vec3.zero)
        (received (at k) ~point:Vec3.zero))

(* {1 Forms} *)

let test_values () =
  let area = Light.area ~intensity:1. ~color:Color.white (pane 4) in
  Expect.prints "spot"
    "spot light, intensity 8, rgb 1 0.5 0, position (0, 2, 0), target (0, 0, \
     0), inner 10, outer 20, unfading"
    Light.pp
    (Light.unfading (spot 10. 20.));
  Expect.prints "area"
    "area light, intensity 1, rgb 1 1 1, corner (1, 2, 3), edge (2, 0, 0), \
     other (0, 0, 4), count 4"
    Light.pp area;
  Alcotest.(check int) "points" 16 (Light.points area);
  Alcotest.(check int) "points of others" 1 (Light.points (spot 1. 2.));
  Alcotest.(check (list Same.vec3))
    "places"
    [ v 1. 2. 3.; v 3. 2. 3.; v 3. 2. 7.; v 1. 2. 7. ]
    (Light.places area)

let suite =
  ( "Lamps",
    [
      Alcotest.test_case "spot" `Quick test_spot;
      Alcotest.test_case "the edge of a cone" `Quick test_edge;
      Alcotest.test_case "no cone" `Quick test_no_cone;
      widest;
      in_cells;
      Alcotest.test_case "spread over a cell" `Quick test_spread;
      mean_of_points;
      point_like;
      Alcotest.test_case "no pane" `Quick test_no_pane;
      Alcotest.test_case "unfading" `Quick test_unfading;
      moved;
      Alcotest.test_case "values" `Quick test_values;
    ] )
