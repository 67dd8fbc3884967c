let () =
  Alcotest.run "toplevel"
    [
      Test_build.suite;
      Test_walk.suite;
      Test_native.suite;
      Test_handover.suite;
      Test_printing.suite;
    ]
