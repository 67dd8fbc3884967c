(** Looking up an embedded interface. *)

val find : string -> Cmi_format.cmi_infos option
(** [find name] is the interface of module [name], if it is one of
    {!Embedded.interfaces}. *)
