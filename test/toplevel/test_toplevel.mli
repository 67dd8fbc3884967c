(** The tests of the library raylab.toplevel; runs when linked. *)
