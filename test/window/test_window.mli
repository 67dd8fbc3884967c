(** The tests of the library raylab.window; runs when linked. *)
