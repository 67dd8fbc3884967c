(** How dune builds the benchmark. *)

val name : string
(** [name] is the profile: ["release"] or ["dev"]. *)
