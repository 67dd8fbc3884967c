(** Watching a file for changes.

    A change is told by what the system knows of the file, so that it does not
    matter whether an editor writes into the file or puts another in its place.
*)

type t
(** The type for watches. *)

val start : string -> t
(** [start path] watches the file at [path] from now on. *)

val has_changed : t -> bool
(** [has_changed watch] is whether the file was changed since the last
    question, or since the start; see {!step}. *)

(** {1 The decision itself} *)

val settling : float
(** [settling] is how long, in seconds, a file must stay the same after a
    change before that is told: an editor may be at work on it. *)

val patience : float
(** [patience] is likewise for a file that is away, since some editors take it
    away for a moment. *)

type 'stamp state
(** The type for what was seen of a file, where two ['stamp]s differ if the
    file was changed in between. *)

val initial : 'stamp option -> 'stamp state
(** [initial stamp] has seen [stamp]; [None] is a file that is not there. *)

val step : now:float -> 'stamp option -> 'stamp state -> 'stamp state * bool
(** [step ~now stamp state] is the state after [stamp] is seen at the time
    [now], and whether that is a change. *)
