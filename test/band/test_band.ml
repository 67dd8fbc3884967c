let () =
  Alcotest.run "band"
    [
      Test_crc32.suite;
      Test_label.suite;
      Test_cover.suite;
      Test_rows.suite;
      Test_uncompressed.suite;
      Test_band_file.suite;
      Test_join.suite;
      Test_damage.suite;
    ]
