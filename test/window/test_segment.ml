open Raylab_window

let point = Alcotest.(pair (float 1e-9) (float 1e-9))
let segment = Alcotest.(option (pair point point))
let box = { Box.left = 0; top = 0; width = 10; height = 20 }

let test_clip () =
  let check name expected line =
    Alcotest.check segment name expected (Segment.clip box line)
  in
  check "inside" (Some ((1., 2.), (3., 4.))) ((1., 2.), (3., 4.));
  check "across" (Some ((0., 5.), (10., 5.))) ((-5., 5.), (25., 5.));
  check "keeps its direction"
    (Some ((10., 5.), (0., 5.)))
    ((25., 5.), (-5., 5.));
  check "a corner" (Some ((0., 1.), (1., 0.))) ((-1., 2.), (2., -1.));
  check "outside" None ((-1., 1.), (1., -1.5));
  check "beside, upright" None ((11., 0.), (11., 5.));
  check "a point" (Some ((3., 3.), (3., 3.))) ((3., 3.), (3., 3.));
  check "from very far" (Some ((0., 10.), (4., 10.))) ((-1e12, 10.), (4., 10.))

let test_dashes () =
  let dash = Alcotest.(list (pair point point)) in
  Alcotest.check dash "two and a rest"
    [ ((0., 0.), (6., 0.)); ((10., 0.), (16., 0.)); ((20., 0.), (22., 0.)) ]
    (Segment.dashes ((0., 0.), (22., 0.)));
  Alcotest.check dash "none" [] (Segment.dashes ((1., 1.), (1., 1.)))

let suite =
  ( "Segment",
    [
      Alcotest.test_case "clip" `Quick test_clip;
      Alcotest.test_case "dashes" `Quick test_dashes;
    ] )
