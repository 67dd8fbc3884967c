val suite : unit Alcotest.test
(** [suite] is the tests called Noise. *)
