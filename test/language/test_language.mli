(** The tests of the library raylab.language; runs when linked. *)
