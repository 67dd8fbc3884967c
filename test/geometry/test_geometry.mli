(** The tests of the library raylab.geometry; runs when linked. *)
