open Raylab_scene
open Test_support
open Build

(* The mirror is the same in all channels. *)
let check what (emission, albedo, mirror) surface =
  Alcotest.check (Same.lobes_near 1e-15) what
    { Lobes.none with emission; albedo; mirror = grey mirror }
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

let gold = rgb 1. 0.5 0.25

(* Colours as weights, and equal indices, which are one. *)
let test_refractions () =
  let white = Color.white and half = grey 0.5 in
  let check what refractions surface =
    let found = (Surface.lobes surface).refractions in
    Alcotest.check Same.lobes what
      { Lobes.none with refractions }
      { Lobes.none with refractions = found }
  in
  let refraction ?(plain = black) ?(fresnel = black) ?(glass = black) index =
    { Lobes.index; plain; fresnel; glass }
  in
  check "refractive"
    [ refraction 1.5 ~plain:gold ]
    (Surface.refractive ~index:1.5 gold);
  let glass = Surface.glass ~index:1.5 gold in
  check "glass" [ refraction 1.5 ~fresnel:white ~glass:gold ] glass;
  check "half glass"
    [ refraction 1.5 ~fresnel:half ~glass:(rgb 0.5 0.25 0.125) ]
    (Surface.mixed [ (0.5, glass) ]);
  check "tinted glass"
    [ refraction 1.5 ~fresnel:gold ~glass:(rgb 1. 0.25 0.0625) ]
    (Surface.tinted [ (gold, glass) ]);
  check "equal indices are one, in the order of the first"
    [
      refraction 1.5 ~plain:(grey 2.) ~fresnel:half ~glass:(rgb 0.5 0.25 0.125);
      refraction 2. ~plain:white;
    ]
    (Surface.mixed
       [
         (0.5, glass);
         (1., Surface.refractive ~index:2. white);
         (2., Surface.mixed [ (1., Surface.refractive ~index:1.5 white) ]);
       ])

let test_highlights () =
  Alcotest.check Same.lobes "equal sharpnesses are one"
    {
      Lobes.none with
      mirror = gold;
      highlights =
        [
          { sharpness = 20.; shine = rgb 1.5 1. 0.75 };
          { sharpness = 5.; shine = grey 2. };
        ];
    }
    (Surface.lobes
       (Surface.tinted
          [
            (gold, Surface.glossy ~sharpness:20. Color.white);
            (gold, Surface.reflective);
            (grey 2., Surface.glossy ~sharpness:5. Color.white);
            (grey 0.5, Surface.glossy ~sharpness:20. Color.white);
          ]))

let map_lobes f { Lobes.emission; albedo; mirror; highlights; refractions } =
  let highlight { Lobes.sharpness; shine } =
    { Lobes.sharpness; shine = f shine }
  and refraction { Lobes.index; plain; fresnel; glass } =
    { Lobes.index; plain = f plain; fresnel = f fresnel; glass = f glass }
  in
  {
    Lobes.emission = f emission;
    albedo = f albedo;
    mirror = f mirror;
    highlights = List.map highlight highlights;
    refractions = List.map refraction refractions;
  }

let scaled k = map_lobes (Color.scale k)

(* Adds to the part of the same key what [add] makes of both. *)
let joined same add parts others =
  let join parts other =
    if List.exists (same other) parts then
      List.map (fun p -> if same other p then add p other else p) parts
    else parts @ [ other ]
  in
  List.fold_left join parts others

let sum a b =
  {
    Lobes.emission = Color.add a.Lobes.emission b.Lobes.emission;
    albedo = Color.add a.albedo b.albedo;
    mirror = Color.add a.mirror b.mirror;
    highlights =
      joined
        (fun (a : Lobes.highlight) b -> a.sharpness = b.sharpness)
        (fun a b -> { a with shine = Color.add a.shine b.shine })
        a.highlights b.highlights;
    refractions =
      joined
        (fun (a : Lobes.refraction) b -> a.index = b.index)
        (fun a b ->
          {
            a with
            plain = Color.add a.plain b.plain;
            fresnel = Color.add a.fresnel b.fresnel;
            glass = Color.add a.glass b.glass;
          })
        a.refractions b.refractions;
  }

(* Parts in the order of their keys. *)
let sorted ({ Lobes.highlights; refractions; _ } as lobes) =
  {
    lobes with
    highlights =
      List.sort
        (fun (a : Lobes.highlight) b -> compare a.sharpness b.sharpness)
        highlights;
    refractions =
      List.sort
        (fun (a : Lobes.refraction) b -> compare a.index b.index)
        refractions;
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
        (sorted (Surface.lobes (Surface.mixed [ p; q ])))
        (sorted (Surface.lobes (Surface.mixed [ q; p ]))))

let finite =
  Property.holds "finite and not negative, whatever the numbers" ~count:1000
    (Generate.surface Generate.extreme) (fun surface ->
      let is_light x = Float.is_finite x && x >= 0. in
      let all = ref true in
      let look ({ Color.r; g; b } as c) =
        all := !all && is_light r && is_light g && is_light b;
        c
      in
      ignore (map_lobes look (Surface.lobes surface) : Lobes.t);
      !all)

(* {1 Values} *)

let dark = Lobes.none

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
      { red with highlights = [ { sharpness = 2.; shine = black } ] };
      {
        red with
        refractions =
          [ { index = 1.5; plain = black; fresnel = black; glass = black } ];
      };
    ];
  let pp ppf = Format.fprintf ppf "@[%a@]" Lobes.pp in
  Expect.prints "a grey mirror"
    "emission rgb 0 0 0, albedo rgb 0.5 0 0, mirror 0.5" pp
    { dark with albedo = rgb 0.5 0. 0.; mirror = grey 0.5 };
  Expect.prints "a coloured one"
    "emission rgb 0 0 0, albedo rgb 0 0 0, mirror rgb 1 0.5 0.25" pp
    { dark with mirror = rgb 1. 0.5 0.25 };
  Expect.prints "glass and highlights"
    "emission rgb 0 0 0, albedo rgb 0 0 0, mirror 0, highlight of sharpness 20:\n\
     0.5, refraction of index 1.5: rgb 1 0.5 0.25, glass of index 1.5: F \
     mirrored,\n\
     (1 - F) * rgb 1 0.5 0.25 through"
    pp
    {
      dark with
      highlights = [ { sharpness = 20.; shine = grey 0.5 } ];
      refractions =
        [ { index = 1.5; plain = gold; fresnel = Color.white; glass = gold } ];
    }

let suite =
  ( "Lobes",
    [
      Alcotest.test_case "simple surfaces" `Quick test_simple;
      Alcotest.test_case "a mix" `Quick test_mix;
      Alcotest.test_case "nested mixes" `Quick test_nested;
      Alcotest.test_case "weight 0" `Quick test_nothing;
      Alcotest.test_case "overflow" `Quick test_overflow;
      Alcotest.test_case "refractions" `Quick test_refractions;
      Alcotest.test_case "highlights" `Quick test_highlights;
      linear;
      order;
      finite;
      Alcotest.test_case "values" `Quick test_values;
    ] )
