let () =
  Alcotest.run "raylab.window"
    [
      Test_dashes.suite; Test_ascii.suite; Test_screen.suite; Test_watch.suite;
    ]
