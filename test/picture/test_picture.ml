let () =
  Alcotest.run "picture"
    [
      Test_format.suite;
      Test_pixels.suite;
      Test_replace.suite;
      Test_failures.suite;
      Test_output.suite;
    ]
