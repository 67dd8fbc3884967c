let () =
  Alcotest.run "toplevel"
    [ Test_walk.suite; Test_native.suite; Test_printing.suite ]
