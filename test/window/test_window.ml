let () =
  Alcotest.run "raylab.window"
    [
      Test_layout.suite;
      Test_refinement.suite;
      Test_raster.suite;
      Test_dashes.suite;
      Test_ascii.suite;
      Test_watch.suite;
      Test_screen.suite;
      Test_key.suite;
    ]
