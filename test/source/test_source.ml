let () =
  Alcotest.run "source"
    [
      Test_lines.suite;
      Test_files.suite;
      Test_sources.suite;
      Test_printable.suite;
      Test_character.suite;
      Test_decimal.suite;
    ]
