(** The tests of the library raylab.expression; runs when linked. *)
