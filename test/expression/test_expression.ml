let () =
  Alcotest.run "expression"
    [
      Test_exact.suite;
      Test_degrees.suite;
      Test_arc.suite;
      Test_power.suite;
      Test_cases.suite;
      Test_libm.suite;
      Test_hash.suite;
      Test_noise.suite;
      Test_range.suite;
      Test_hsv.suite;
    ]
