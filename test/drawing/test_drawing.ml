let () =
  Alcotest.run "drawing"
    [
      Test_clip.suite;
      Test_path.suite;
      Test_svg.suite;
      Test_path_picture.suite;
      Test_labels.suite;
      Test_overlay.suite;
    ]
