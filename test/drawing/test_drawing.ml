let () =
  Alcotest.run "drawing"
    [ Test_svg.suite; Test_path_picture.suite; Test_labels.suite ]
