(** Changes of a file that is watched, told once it has settled. *)

type 'stamp t
(** The type for what was seen of a file, where two ['stamp]s differ if the
    file was changed in between. *)

val settling : float
(** [settling] is how long, in seconds, a file must stay the same after a
    change before that is told: an editor may be at work on it. *)

val patience : float
(** [patience] is likewise for a file that is away, since some editors take it
    away for a moment. *)

val initial : 'stamp option -> 'stamp t
(** [initial stamp] has seen [stamp]; [None] is a file that is not there. *)

val step : now:float -> 'stamp option -> 'stamp t -> 'stamp t * bool
(** [step ~now stamp seen] is [seen] and then [stamp], at the time [now], and
    whether a change is told. *)
