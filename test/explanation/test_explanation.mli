(** The tests of the library raylab.explanation; runs when linked. *)
