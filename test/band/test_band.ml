let () =
  Alcotest.run "band"
    [
      Test_label.suite;
      Test_cover.suite;
      Test_band_file.suite;
      Test_join.suite;
      Test_damage.suite;
    ]
