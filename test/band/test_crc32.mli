val suite : unit Alcotest.test
(** [suite] is the tests called CRC-32. *)
