(** Spans: pieces of a source text. *)

type t
(** The type for spans. A span takes one machine word, because a scene of a
    million objects has several million of them. *)

val make : start:int -> stop:int -> t
(** [make ~start ~stop] is the text from byte [start] up to but not including
    byte [stop]. Offsets go up to 2^31, which is as long as a scene may be. *)

val start : t -> int
(** [start span] is the offset of its first byte. *)

val stop : t -> int
(** [stop span] is the offset after its last byte. *)
