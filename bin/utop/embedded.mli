(** The compiled interfaces of the library and of OCaml's own. *)

val interfaces : (string * string) list
(** [interfaces] is the [Cmi_format.cmi_infos] of each module, under its name,
    marshalled. *)
