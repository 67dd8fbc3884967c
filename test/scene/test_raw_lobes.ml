open Raylab_geometry
open Raylab_scene
open Test_support
open Build

let check what expected found =
  Alcotest.check Same.lobes what expected (Raw_lobes.read found)

let lobes ?(emission = Color.black) ?(albedo = Color.black)
    ?(mirror = Color.black) ?(refractions = []) () =
  { Lobes.none with emission; albedo; mirror; refractions }

let write raw surface =
  Surface.(write no_machines) surface (Spot.create ()) raw

let matt r g b = Surface.diffusive (rgb r g b)
let glow r g b = Surface.luminous (rgb r g b)

(* 2 (1, 2, 3) + 0.5 (4, 0, 2) = (4, 4, 7); and where a product or a sum is no
   double. *)
let test_mix () =
  let raw = Raw_lobes.create () in
  check "at first" (lobes ()) raw;
  write raw
    (Surface.mixed
       [
         (2., matt 1. 2. 3.);
         (0.5, matt 4. 0. 2.);
         (3., glow 1. 0. 0.5);
         (0.25, Surface.reflective);
       ]);
  check "lobe by lobe"
    (lobes ~albedo:(rgb 4. 4. 7.) ~emission:(rgb 3. 0. 1.5) ~mirror:(grey 0.25)
       ())
    raw;
  write raw
    (Surface.mixed
       [
         (1e200, matt 1e200 1. 0.);
         (1., matt max_float 0. 0.);
         (max_float, Surface.reflective);
         (max_float, Surface.reflective);
       ]);
  check "the largest double"
    (lobes ~albedo:(rgb max_float 1e200 0.) ~mirror:(grey max_float) ())
    raw

(* 2 (0.5 mirror + 3 (1, 2, 0)) + 4 glow, the outer mix and the inner one
   last: albedo 4 * 2 * 3 (1, 2, 0), mirror 4 * 2 * 0.5. *)
let nested =
  Surface.mixed
    [
      (0.5, glow 4. 0. 0.);
      ( 4.,
        Surface.mixed
          [
            (1., glow 0. 1. 0.);
            ( 2.,
              Surface.mixed [ (0.5, Surface.reflective); (3., matt 1. 2. 0.) ]
            );
          ] );
    ]

let expected =
  lobes ~emission:(rgb 2. 4. 0.) ~albedo:(rgb 24. 48. 0.) ~mirror:(grey 4.) ()

let test_nested () =
  let raw = Raw_lobes.create () in
  write raw nested;
  check "by hand" expected raw

let glass =
  Surface.mixed [ (1., Surface.glass ~index:1.5 Color.white); (1., nested) ]

(* What was in it before is forgotten. *)
let test_anew () =
  let raw = Raw_lobes.create () in
  let write = write raw in
  write nested;
  write (glow 1. 2. 3.);
  check "anew" (lobes ~emission:(rgb 1. 2. 3.) ()) raw;
  write glass;
  write glass;
  check "with glass"
    {
      expected with
      refractions =
        [
          {
            index = 1.5;
            plain = Color.black;
            fresnel = Color.white;
            glass = Color.white;
          };
        ];
    }
    raw;
  write nested;
  check "and again" expected raw

let suite =
  ( "Raw_lobes",
    [
      Alcotest.test_case "mix" `Quick test_mix;
      Alcotest.test_case "nested mixes" `Quick test_nested;
      Alcotest.test_case "anew" `Quick test_anew;
    ] )
