open Raylab_scene
open Test_support
open Build

let check = Alcotest.check Same.surface
let matt = Surface.diffusive (rgb 1. 0.5 0.)
let glow = Surface.luminous Color.red
let mirror = Surface.reflective

let test_inlined () =
  (* 0.5 (0.2 mirror + 0.4 glow) + 3 matt, written without the inner mix *)
  check "an early mix"
    (Surface.mixed [ (0.1, mirror); (0.2, glow); (3., matt) ])
    (Surface.mixed
       [ (0.5, Surface.mixed [ (0.2, mirror); (0.4, glow) ]); (3., matt) ]);
  (* the last one stays: what follows a mix belongs to it *)
  let last = Surface.mixed [ (0.2, mirror); (0.4, glow) ] in
  match Surface.mixed [ (3., matt); (0.5, last) ] with
  | Mixed { parts = [ ({ r = 3.; _ }, first); ({ r = 0.5; _ }, second) ]; _ }
    ->
      check "before it" matt first;
      check "a late mix" last second
  | other -> Alcotest.failf "%a" Surface.pp other

(* The last part of an early mix is early too. *)
let test_inlined_twice () =
  check "two deep"
    (Surface.mixed [ (1., mirror); (0.25, glow); (3., matt) ])
    (Surface.mixed
       [
         ( 0.5,
           Surface.mixed [ (2., mirror); (0.5, Surface.mixed [ (1., glow) ]) ]
         );
         (3., matt);
       ])

let rec nested n surface =
  if n = 0 then surface else nested (n - 1) (Surface.mixed [ (1., surface) ])

let nesting = function Surface.Mixed { nesting; _ } -> nesting | _ -> 0

let test_nesting () =
  let deepest = nested Surface.max_nesting mirror in
  let check what expected surface =
    Alcotest.(check int) what expected (nesting surface)
  in
  check "none in it" 1 (Surface.mixed [ (1., mirror); (2., glow) ]);
  check "two" 2 (Surface.mixed [ (1., matt); (2., nested 1 glow) ]);
  check "the deepest" 1000 deepest;
  check "an early one is inlined" 1
    (Surface.mixed [ (1., deepest); (1., matt) ]);
  check "in other colours" 1000 (Surface.map_colors Fun.id deepest);
  Expect.invalid "deeper" (fun () -> Surface.mixed [ (1., deepest) ]);
  Expect.invalid "in a checker" (fun () -> Surface.checker 1. matt deepest);
  Expect.invalid "after others" (fun () ->
      Surface.mixed [ (1., matt); (1., deepest) ])

let test_equal () =
  let differs what a b =
    Alcotest.(check bool) what false (Surface.equal a b)
  in
  differs "kind" (Surface.diffusive Color.red) glow;
  differs "colour" (Surface.luminous Color.blue) glow;
  let glass = Surface.glass ~index:1.5 and gold = rgb 1. 0.5 0. in
  differs "index" (glass gold) (Surface.glass ~index:1.6 gold);
  differs "colour of glass" (glass gold) (glass Color.white);
  differs "glass" (glass gold) (Surface.refractive ~index:1.5 gold);
  differs "sharpness"
    (Surface.glossy ~sharpness:2. gold)
    (Surface.glossy ~sharpness:3. gold);
  differs "weight that is a colour"
    (Surface.tinted [ (gold, glow) ])
    (Surface.mixed [ (1., glow) ]);
  differs "weight"
    (Surface.mixed [ (1., glow) ])
    (Surface.mixed [ (2., glow) ]);
  differs "number of parts"
    (Surface.mixed [ (1., glow) ])
    (Surface.mixed [ (1., glow); (1., glow) ]);
  differs "size" (Surface.checker 1. matt glow) (Surface.checker 2. matt glow);
  differs "even" (Surface.checker 1. matt glow) (Surface.checker 1. glow glow);
  differs "odd" (Surface.checker 1. matt glow) (Surface.checker 1. matt matt);
  differs "a mix of one and the one" (Surface.mixed [ (1., glow) ]) glow

let test_invalid () =
  Expect.invalid "no parts" (fun () -> Surface.mixed []);
  List.iter
    (fun bad ->
      Expect.invalid "weight" (fun () -> Surface.mixed [ (bad, mirror) ]);
      Expect.invalid "diffusive" (fun () -> Surface.diffusive (rgb 0. bad 0.));
      Expect.invalid "checker" (fun () -> Surface.checker bad matt matt);
      Expect.invalid "luminous" (fun () -> Surface.luminous (rgb 0. 0. bad));
      Expect.invalid "glossy" (fun () ->
          Surface.glossy ~sharpness:1. (grey bad));
      Expect.invalid "sharpness" (fun () ->
          Surface.glossy ~sharpness:bad (grey 1.));
      Expect.invalid "refractive" (fun () ->
          Surface.refractive ~index:bad (grey 1.));
      Expect.invalid "glass" (fun () -> Surface.glass ~index:bad (grey 1.));
      Expect.invalid "tinted" (fun () ->
          Surface.tinted [ (rgb 1. bad 1., mirror) ]);
      Expect.invalid "map_colors" (fun () ->
          let mix = Surface.mixed [ (1., matt) ] in
          Surface.map_colors (fun _ -> grey bad) mix))
    [ nan; infinity; -1. ];
  Expect.invalid "index 0" (fun () -> Surface.glass ~index:0. (grey 1.));
  Expect.invalid "index 0" (fun () -> Surface.refractive ~index:0. (grey 1.));
  check "sharpness 0"
    (Surface.glossy ~sharpness:0. (grey 1.))
    (Surface.glossy ~sharpness:(-0.) (grey 1.))

let test_map_colors () =
  check "every colour"
    (Surface.mixed
       [
         (2., mirror); (1., Surface.mixed [ (3., Surface.luminous (grey 2.)) ]);
       ])
    (Surface.map_colors
       (fun _ -> grey 2.)
       (Surface.mixed [ (2., mirror); (1., Surface.mixed [ (3., glow) ]) ]))

(* Weights that are numbers stay. *)
let test_grey_weights () =
  let colored = rgb 1. 0.5 0. in
  check "weights that are colours"
    (Surface.tinted
       [
         (grey 2., Surface.glass ~index:1.5 (grey 2.));
         (grey 0.1, Surface.refractive ~index:1.5 (grey 2.));
         (grey 0.2, Surface.glossy ~sharpness:9. (grey 2.));
       ])
    (Surface.map_colors
       (fun _ -> grey 2.)
       (Surface.tinted
          [
            (colored, Surface.glass ~index:1.5 colored);
            (grey 0.1, Surface.refractive ~index:1.5 colored);
            (grey 0.2, Surface.glossy ~sharpness:9. colored);
          ]))

let test_at () =
  let mix = Surface.mixed [ (2., mirror); (1., glow) ] in
  Alcotest.(check bool) "varies" false (Surface.varies mix);
  check "anywhere" mix (Surface.at mix (v 1. 2. 3.));
  let checkered = Surface.mixed [ (2., Surface.checker 1. mirror matt) ] in
  Alcotest.(check bool) "varies" true (Surface.varies checkered);
  check "in a mix"
    (Surface.mixed [ (2., matt) ])
    (Surface.at checkered (v 1.5 0. 0.))

let test_checker () =
  let checker = Surface.checker 0.1 matt mirror in
  let check what expected point =
    check what expected (Surface.at checker point)
  in
  check "the origin" matt (v 0. 0. 0.);
  check "the next cube" mirror (v 0.15 0.05 0.05);
  check "beyond an edge" matt (v 0.15 0.15 0.05);
  check "beyond a corner" mirror (v 0.15 0.15 0.15);
  check "before the origin" mirror (v (-0.05) 0.05 0.05);
  check "diagonally before it" matt (v (-0.05) (-0.05) 0.05);
  check "far away" matt (v 1e300 1e-300 0.05);
  (* 0.3 / 0.1 is a little less than 3 *)
  check "between two" mirror (v 0.3 0.05 0.05);
  check "a little before" mirror (v (0.3 -. 1e-15) 0.05 0.05);
  check "a little beyond" mirror (v (0.3 +. 1e-15) 0.05 0.05);
  check "clearly before" matt (v 0.2999 0.05 0.05)

(* Two to the power of 900 surfaces. *)
let test_shared () =
  let rec build n surface =
    if n = 0 then surface
    else build (n - 1) (Surface.checker 1. surface surface)
  in
  Alcotest.(check int) "count" 1_000_000_000 (Surface.count (build 900 matt));
  Alcotest.(check int) "of few" 7 (Surface.count (build 2 matt))

let test_paint () =
  let check what expected surface =
    Alcotest.(check (option Same.color)) what expected (Surface.paint surface)
  in
  check "diffusive" (Some (rgb 1. 0.5 0.)) matt;
  check "mirror" None mirror;
  check "luminous" None glow;
  check "mix" None (Surface.mixed [ (1., matt) ])

let test_pp () =
  Expect.prints "as in a scene" "mixed 0.5 diffusive 1 0.5 0 0.25 reflective"
    Surface.pp
    (Surface.mixed [ (0.5, matt); (0.25, mirror) ]);
  let nested = Surface.checker 2. matt (Surface.mixed [ (0.25, mirror) ]) in
  Expect.prints "a mix that ends in a mix"
    "mixed 1 (checker 2 diffusive 1 0.5 0 mixed 0.25 reflective) 3 reflective"
    Surface.pp
    (Surface.mixed [ (1., nested); (3., mirror) ]);
  Expect.prints "luminous" "luminous 1 0 0" Surface.pp glow;
  Expect.prints "weights that are colours"
    "mixed [1, 0.5, 0] glass 1.5 1 1 1 0.5 glossy 20 1 0 0 2 refractive 1.3 1 \
     0 0"
    Surface.pp
    (Surface.tinted
       [
         (rgb 1. 0.5 0., Surface.glass ~index:1.5 Color.white);
         (grey 0.5, Surface.glossy ~sharpness:20. Color.red);
         (grey 2., Surface.refractive ~index:1.3 Color.red);
       ])

let suite =
  ( "Surface",
    [
      Alcotest.test_case "early mixes are inlined" `Quick test_inlined;
      Alcotest.test_case "nested early mixes" `Quick test_inlined_twice;
      Alcotest.test_case "nesting" `Quick test_nesting;
      Alcotest.test_case "equal" `Quick test_equal;
      Alcotest.test_case "invalid" `Quick test_invalid;
      Alcotest.test_case "map_colors" `Quick test_map_colors;
      Alcotest.test_case "weights in grey" `Quick test_grey_weights;
      Alcotest.test_case "checker" `Quick test_checker;
      Alcotest.test_case "parts that are shared" `Quick test_shared;
      Alcotest.test_case "at a point" `Quick test_at;
      Alcotest.test_case "paint" `Quick test_paint;
      Alcotest.test_case "pp" `Quick test_pp;
    ] )
