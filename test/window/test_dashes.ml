open Raylab_window

let point = Alcotest.(pair (float 1e-9) (float 1e-9))

let test_cut () =
  let check name expected ends =
    Alcotest.(check (list (pair point point)))
      name expected
      (Dashes.cut (6., 4.) ends)
  in
  check "two and a rest"
    [ ((0., 0.), (6., 0.)); ((10., 0.), (16., 0.)); ((20., 0.), (22., 0.)) ]
    ((0., 0.), (22., 0.));
  check "none" [] ((1., 1.), (1., 1.))

let suite = ("Dashes", [ Alcotest.test_case "cut" `Quick test_cut ])
