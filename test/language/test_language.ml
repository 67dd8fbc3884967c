let () =
  Alcotest.run "language"
    [
      Test_lexer.suite;
      Test_keyword.suite;
      Test_suggestion.suite;
      Test_lookalike.suite;
      Test_encoding.suite;
      Test_grammar.suite;
      Test_mixes.suite;
      Test_numbers.suite;
      Test_header.suite;
      Test_error_place.suite;
      Test_error_messages.suite;
      Test_program_errors.suite;
      Test_habit.suite;
      Test_limits.suite;
      Test_program.suite;
      Test_provenance.suite;
      Test_printed_expression.suite;
      Test_random_program.suite;
      Test_expectation.suite;
      Test_second_file.suite;
      Test_include.suite;
      Test_load.suite;
      Test_round_trip.suite;
      Test_hostile.suite;
    ]
