(** The tests of the library raylab.scene; runs when linked. *)
