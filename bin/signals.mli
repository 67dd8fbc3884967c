(** Signals that end the program. *)

(** {1 Ends from outside}

    They are Ctrl-C, the loss of its terminal, a request to end or to quit, and
    the end of the time that it was given (ulimit -t). It dies of the signal
    itself, since a shell that runs it in a loop ends the loop only then. A
    signal that is ignored when the program starts, as after [nohup], stays
    ignored. *)

val cleaning : (unit -> unit) -> (unit -> 'a) -> 'a
(** [cleaning clean f] is [f ()]. A signal that comes meanwhile has [clean ()]
    done, on any domain and between any two steps of [f], and then does what it
    would have done without. *)

val at_once : (unit -> 'a) -> 'a
(** [at_once f] is [f ()], during which a signal ends the program at once, and
    nothing is cleaned: also where it waits in C for somebody who never
    answers, and no handler would run. *)

(** {1 Readers that go away}

    They are known by the signal SIGPIPE. What it does is set anew here,
    whatever it did when the program started. *)

val despite_readers : (unit -> 'a) -> 'a
(** [despite_readers f] is [f ()], in which a reader that has gone away is an
    error of writing. *)

val for_readers : (unit -> 'a) -> 'a
(** [for_readers f] is [f ()], during which the program dies of the signal if
    it writes to a reader that has gone away, without a word, as other programs
    do. *)
