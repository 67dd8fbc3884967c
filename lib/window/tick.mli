(** Calls that block, interrupted after a while.

    Graphics can wait for the next event, but not for a limited time, and what
    it tells without waiting leaves out clicks. *)

val within : seconds:float -> (unit -> 'a) -> 'a option
(** [within ~seconds wait] is [wait ()], or [None] if that has not ended after
    some [seconds]. [wait] must be a single call of a C function that releases
    the runtime lock while it blocks, so that nothing is lost if it is
    interrupted. It takes the interval timer and the signal SIGALRM. Only the
    main domain may call this. *)

val quiet : unit -> unit
(** [quiet ()] stops the interval timer and makes its signal do nothing. *)

val not_here : unit -> unit
(** [not_here ()] keeps interruptions away from the calling domain, and from
    those that it spawns. *)
