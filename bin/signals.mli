(** Signals that end the program: Ctrl-C, the loss of its terminal, and a
    request to end.

    It dies of the signal itself, since a shell that runs it in a loop ends the
    loop only then. A signal that is ignored when the program starts, as after
    [nohup], stays ignored. *)

val cleaning : (unit -> unit) -> (unit -> 'a) -> 'a
(** [cleaning clean f] is [f ()]. A signal that comes meanwhile has [clean ()]
    done, on any domain and between any two steps of [f], and then does what it
    would have done without. *)

val at_once : (unit -> 'a) -> 'a
(** [at_once f] is [f ()], during which a signal ends the program at once, and
    nothing is cleaned: also where it waits in C for somebody who never
    answers, and no handler would run. *)
