open Raylab_scene
open Test_support
open Build

(* The mirror is the same in all channels. *)
let check what (emission, albedo, mirror) surface =
  Alcotest.check (Same.lobes_near 1e-15) what
    { Lobes.emission; albedo; mirror = grey mirror }
    (Surface.lobes surface)

let black = Color.black

let test_simple () =
  check "diffusive"
    (black, rgb 1. 2. 3., 0.)
    (Surface.diffusive (rgb 1. 2. 3.));
  check "reflective" (black, black, 1.) Surface.reflective;
  check "luminous" (rgb 1. 2. 3., black, 0.) (Surface.luminous (rgb 1. 2. 3.))

(* 0.5 (4, 0, 2) + 0.25 (0, 4, 4) = (2, 1, 2); weights need no sum of 1. *)
let test_mix () =
  check "a mix"
    (rgb 3. 0. 0., rgb 2. 1. 2., 7.)
    (Surface.mixed
       [
         (0.5, Surface.diffusive (rgb 4. 0. 2.));
         (7., Surface.reflective);
         (3., Surface.luminous Color.red);
         (0.25, Surface.diffusive (rgb 0. 4. 4.));
       ])

(* 0.5 red emitted; 2 (0.25 mirror + 3 (0.5 (1, 1, 1))) gives a mirror of 0.5
   and an albedo of 2 * 3 * 0.5 = 3. *)
let test_nested () =
  check "mixes in mixes"
    (rgb 0.5 0. 0., grey 3., 0.5)
    (Surface.mixed
       [
         (0.5, Surface.luminous Color.red);
         ( 2.,
           Surface.mixed
             [
               (0.25, Surface.reflective);
               (3., Surface.mixed [ (0.5, Surface.diffusive Color.white) ]);
             ] );
       ])

let test_nothing () =
  check "weight 0" (black, black, 0.)
    (Surface.mixed [ (0., Surface.reflective) ])

(* 1e200 * 1e200 is no double. *)
let test_overflow () =
  check "the largest double" (black, black, max_float)
    (Surface.mixed [ (1e200, Surface.mixed [ (1e200, Surface.reflective) ]) ])

let scaled k { Lobes.emission; albedo; mirror } =
  {
    Lobes.emission = Color.scale k emission;
    albedo = Color.scale k albedo;
    mirror = Color.scale k mirror;
  }

let sum a b =
  {
    Lobes.emission = Color.add a.Lobes.emission b.Lobes.emission;
    albedo = Color.add a.albedo b.albedo;
    mirror = Color.add a.mirror b.mirror;
  }

let is_near = Alcotest.equal (Same.lobes_near 1e-12)

let weighted_surfaces =
  let part =
    QCheck2.Gen.pair
      (Generate.at_least_0 Generate.everyday)
      (Generate.surface Generate.everyday)
  in
  QCheck2.Gen.pair part part

(* The mixing of surfaces is the adding of lobes, however the parts nest:
   this is also what makes it right to inline an early mix. *)
let linear =
  Property.holds "the lobes of a mix are the mix of lobes" ~count:1000
    weighted_surfaces (fun ((w, a), (w', b)) ->
      is_near
        (Surface.lobes (Surface.mixed [ (w, a); (w', b) ]))
        (sum (scaled w (Surface.lobes a)) (scaled w' (Surface.lobes b))))

let order =
  Property.holds "the order of parts does not matter" weighted_surfaces
    (fun (p, q) ->
      is_near
        (Surface.lobes (Surface.mixed [ p; q ]))
        (Surface.lobes (Surface.mixed [ q; p ])))

let finite =
  Property.holds "finite and not negative, whatever the numbers" ~count:1000
    (Generate.surface Generate.extreme) (fun surface ->
      let { Lobes.emission; albedo; mirror } = Surface.lobes surface in
      let is_light x = Float.is_finite x && x >= 0. in
      List.for_all
        (fun { Color.r; g; b } -> is_light r && is_light g && is_light b)
        [ emission; albedo; mirror ])

(* {1 Values} *)

let dark = { Lobes.emission = black; albedo = black; mirror = black }

let test_values () =
  let red = { dark with mirror = Color.red } in
  Alcotest.(check bool) "equal" true (Lobes.equal red red);
  List.iter
    (fun other -> Alcotest.(check bool) "not" false (Lobes.equal red other))
    [
      dark;
      { dark with mirror = Color.white };
      { red with albedo = Color.red };
      { red with emission = Color.red };
    ];
  let pp ppf = Format.fprintf ppf "@[%a@]" Lobes.pp in
  Expect.prints "a grey mirror"
    "emission rgb 0 0 0, albedo rgb 0.5 0 0, mirror 0.5" pp
    { dark with albedo = rgb 0.5 0. 0.; mirror = grey 0.5 };
  Expect.prints "a coloured one"
    "emission rgb 0 0 0, albedo rgb 0 0 0, mirror rgb 1 0.5 0.25" pp
    { dark with mirror = rgb 1. 0.5 0.25 }

let suite =
  ( "Lobes",
    [
      Alcotest.test_case "simple surfaces" `Quick test_simple;
      Alcotest.test_case "a mix" `Quick test_mix;
      Alcotest.test_case "nested mixes" `Quick test_nested;
      Alcotest.test_case "weight 0" `Quick test_nothing;
      Alcotest.test_case "overflow" `Quick test_overflow;
      linear;
      order;
      finite;
      Alcotest.test_case "values" `Quick test_values;
    ] )
