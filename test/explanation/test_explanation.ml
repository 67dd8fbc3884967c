let () =
  Alcotest.run "explanation"
    [
      Test_words.suite;
      Test_summary.suite;
      Test_illumination.suite;
      Test_questions.suite;
      Test_swatch.suite;
      Test_report.suite;
      Test_parts.suite;
      Test_steps.suite;
      Test_json.suite;
    ]
