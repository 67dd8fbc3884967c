(** The tests of the library raylab.tracer; runs when linked. *)
