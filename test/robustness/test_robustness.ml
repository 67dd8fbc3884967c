let () = Alcotest.run "robustness" [ Test_finite.suite ]
