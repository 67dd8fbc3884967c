val number : string
(** [number] is the version of raylab, as dune-project has it. *)
