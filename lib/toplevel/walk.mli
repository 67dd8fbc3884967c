(** Walks: places between the events of a sequence, with ways in both
    directions. *)

open Raylab_tracer

type t
(** The type for places in a sequence of events: what has been seen, and what
    is to come. Going on or back gives another place; the old one remains. *)

val start : Event.t Seq.t -> t
(** [start events] is the place before the first of [events]. *)

val next : t -> (Event.t * t) option
(** [next place] is the event that comes and the place after it, or [None] at
    the end. *)

val back : t -> (Event.t * t) option
(** [back place] is the event before the one seen last, and the place after it:
    one [next] undone. [None] if fewer than two events have been seen. *)
