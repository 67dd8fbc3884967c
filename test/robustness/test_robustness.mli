(** What must hold whatever happens; runs when linked. *)
