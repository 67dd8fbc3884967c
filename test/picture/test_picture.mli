(** The tests of the library raylab.picture; runs when linked. *)
