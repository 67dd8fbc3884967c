open Raylab_drawing

let point = Alcotest.(pair (float 1e-9) (float 1e-9))
let window = { Rectangle.left = 0.; top = 0.; right = 10.; bottom = 20. }

let test_segment () =
  let check name expected line =
    Alcotest.(check (option (pair point point)))
      name expected (Clip.segment window line)
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

let suite = ("Clip", [ Alcotest.test_case "segment" `Quick test_segment ])
