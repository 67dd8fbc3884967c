(** Small hostile texts, at random. *)

type kind = string * (Random.State.t -> string)
(** The type for kinds of texts: a name and a generator. *)

val kinds : gallery:string list -> kind list
(** [kinds ~gallery] is all kinds, of which one damages the scenes in
    [gallery]. *)
