(* The program raylab; see its manual pages. *)
