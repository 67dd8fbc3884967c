let () =
  Alcotest.run "mesh_file"
    [
      Test_polygon.suite;
      Test_words.suite;
      Test_obj.suite;
      Test_ply.suite;
      Test_stl.suite;
      Test_broken.suite;
    ]
