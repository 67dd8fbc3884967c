(** Prints the states of a grammar as an OCaml module. *)
