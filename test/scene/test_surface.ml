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
  | Mixed { parts = [ (3., first); (0.5, second) ]; _ } ->
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
  Expect.invalid "after others" (fun () ->
      Surface.mixed [ (1., matt); (1., deepest) ])

let test_equal () =
  let differs what a b =
    Alcotest.(check bool) what false (Surface.equal a b)
  in
  differs "kind" (Surface.diffusive Color.red) glow;
  differs "colour" (Surface.luminous Color.blue) glow;
  differs "weight"
    (Surface.mixed [ (1., glow) ])
    (Surface.mixed [ (2., glow) ]);
  differs "number of parts"
    (Surface.mixed [ (1., glow) ])
    (Surface.mixed [ (1., glow); (1., glow) ]);
  differs "a mix of one and the one" (Surface.mixed [ (1., glow) ]) glow

let test_invalid () =
  Expect.invalid "no parts" (fun () -> Surface.mixed []);
  List.iter
    (fun bad ->
      Expect.invalid "weight" (fun () -> Surface.mixed [ (bad, mirror) ]);
      Expect.invalid "diffusive" (fun () -> Surface.diffusive (rgb 0. bad 0.));
      Expect.invalid "luminous" (fun () -> Surface.luminous (rgb 0. 0. bad));
      Expect.invalid "map_colors" (fun () ->
          let mix = Surface.mixed [ (1., matt) ] in
          Surface.map_colors (fun _ -> grey bad) mix))
    [ nan; infinity; -1. ]

let test_map_colors () =
  check "every colour"
    (Surface.mixed
       [
         (2., mirror); (1., Surface.mixed [ (3., Surface.luminous (grey 2.)) ]);
       ])
    (Surface.map_colors
       (fun _ -> grey 2.)
       (Surface.mixed [ (2., mirror); (1., Surface.mixed [ (3., glow) ]) ]))

(* None varies so far. *)
let test_at () =
  let mix = Surface.mixed [ (2., mirror); (1., glow) ] in
  Alcotest.(check bool) "varies" false (Surface.varies mix);
  check "anywhere" mix (Surface.at mix (v 1. 2. 3.))

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
  Expect.prints "luminous" "luminous 1 0 0" Surface.pp glow

let suite =
  ( "Surface",
    [
      Alcotest.test_case "early mixes are inlined" `Quick test_inlined;
      Alcotest.test_case "nested early mixes" `Quick test_inlined_twice;
      Alcotest.test_case "nesting" `Quick test_nesting;
      Alcotest.test_case "equal" `Quick test_equal;
      Alcotest.test_case "invalid" `Quick test_invalid;
      Alcotest.test_case "map_colors" `Quick test_map_colors;
      Alcotest.test_case "at a point" `Quick test_at;
      Alcotest.test_case "paint" `Quick test_paint;
      Alcotest.test_case "pp" `Quick test_pp;
    ] )
