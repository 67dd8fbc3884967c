(** The tests of the library raylab.band; runs when linked. *)
