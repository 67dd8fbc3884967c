val suite : unit Alcotest.test
