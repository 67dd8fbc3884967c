let () =
  Alcotest.run "toplevel"
    [ Test_walk.suite; Test_fast.suite; Test_printing.suite ]
