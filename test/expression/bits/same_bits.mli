(** A program that prints checksums; runs when linked. *)
