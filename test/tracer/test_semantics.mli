(** The equations of [doc/semantics.mld], by the functions that they name, and
    the tracer beside them. *)

val suite : unit Alcotest.test
(** [suite] is the tests called Semantics. *)
