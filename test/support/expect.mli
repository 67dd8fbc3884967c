(** Expectations that alcotest has no word for. *)

val invalid : string -> (unit -> 'a) -> unit
(** [invalid what f] fails unless [f ()] raises [Invalid_argument]. *)

val contains : string -> part:string -> string -> unit
(** [contains what ~part text] fails unless [part] occurs in [text]. *)

val prints : string -> string -> (Format.formatter -> 'a -> unit) -> 'a -> unit
(** [prints what expected pp value] fails unless [pp] prints [value] as
    [expected]. *)
