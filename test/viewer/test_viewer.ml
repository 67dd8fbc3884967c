let () =
  Alcotest.run "raylab.viewer"
    [
      Test_layout.suite;
      Test_refinement.suite;
      Test_raster.suite;
      Test_message.suite;
      Test_changes.suite;
      Test_key.suite;
      Test_hand.suite;
      Test_orbit.suite;
      Test_steps.suite;
    ]
