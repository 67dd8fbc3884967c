let () = Alcotest.run "toplevel" [ Test_walk.suite; Test_fast.suite ]
