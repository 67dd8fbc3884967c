open Raylab_scene
open Test_support
open Build

let check what (emission, albedo, mirror) surface =
  Alcotest.check (Same.meaning_near 1e-15) what
    { Surface.emission; albedo; mirror }
    (Surface.meaning surface)

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

let scaled k { Surface.emission; albedo; mirror } =
  {
    Surface.emission = Color.scale k emission;
    albedo = Color.scale k albedo;
    mirror = k *. mirror;
  }

let sum a b =
  {
    Surface.emission = Color.add a.Surface.emission b.Surface.emission;
    albedo = Color.add a.albedo b.albedo;
    mirror = a.mirror +. b.mirror;
  }

let is_near = Alcotest.equal (Same.meaning_near 1e-12)

let weighted_surfaces =
  let part =
    QCheck2.Gen.pair
      (Generate.at_least_0 Generate.everyday)
      (Generate.surface Generate.everyday)
  in
  QCheck2.Gen.pair part part

(* The mixing of surfaces is the adding of meanings, however the parts nest:
   this is also what makes it right to inline an early mix. *)
let linear =
  Property.holds "the meaning of a mix is the mix of meanings" ~count:1000
    weighted_surfaces (fun ((w, a), (w', b)) ->
      is_near
        (Surface.meaning (Surface.mixed [ (w, a); (w', b) ]))
        (sum (scaled w (Surface.meaning a)) (scaled w' (Surface.meaning b))))

let order =
  Property.holds "the order of parts does not matter" weighted_surfaces
    (fun (p, q) ->
      is_near
        (Surface.meaning (Surface.mixed [ p; q ]))
        (Surface.meaning (Surface.mixed [ q; p ])))

let finite =
  Property.holds "finite and not negative, whatever the numbers" ~count:1000
    (Generate.surface Generate.extreme) (fun surface ->
      let { Surface.emission; albedo; mirror } = Surface.meaning surface in
      List.for_all
        (fun x -> Float.is_finite x && x >= 0.)
        [
          emission.r; emission.g; emission.b; albedo.r; albedo.g; albedo.b;
          mirror;
        ] [@ocamlformat "disable"])

let suite =
  ( "Surface.meaning",
    [
      Alcotest.test_case "simple surfaces" `Quick test_simple;
      Alcotest.test_case "a mix" `Quick test_mix;
      Alcotest.test_case "nested mixes" `Quick test_nested;
      Alcotest.test_case "weight 0" `Quick test_nothing;
      Alcotest.test_case "overflow" `Quick test_overflow;
      linear;
      order;
      finite;
    ] )
