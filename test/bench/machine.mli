(** Where and with what was measured. *)

val cores : unit -> int
(** [cores ()] is the number of cores that this process may use. *)

val describe : unit -> (string * string) list
(** [describe ()] is processor, compiler, version of raylab, how busy the
    machine is, and today's date (UTC), each with its name. *)
