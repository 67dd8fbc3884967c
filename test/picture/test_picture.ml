let () =
  Alcotest.run "picture"
    [
      Test_crc32.suite;
      Test_rows.suite;
      Test_uncompressed.suite;
      Test_png_file.suite;
      Test_format.suite;
      Test_pixels.suite;
      Test_replace.suite;
      Test_failures.suite;
      Test_fixed.suite;
      Test_output.suite;
    ]
