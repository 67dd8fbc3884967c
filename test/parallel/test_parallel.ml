let () = Alcotest.run "parallel" [ Test_iter.suite; Test_failures.suite ]
