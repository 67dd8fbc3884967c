(* Compares the hierarchy with brute force over the gallery. *)
