(** Work in a process of its own, so that its peak memory and processor time
    are its alone. Nothing here may be called once a domain was spawned. *)

type clock = {
  wall : float;  (** seconds on the wall *)
  cpu : float;  (** processor seconds, of all threads, user and system *)
}
(** The type for measured times. *)

val timed : (unit -> 'a) -> 'a * clock
(** [timed work] is [work ()], in this process, and the time that it took. *)

val compute : (unit -> 'a) -> ('a, string) result
(** [compute work] is [work ()], done by a child process, or why there is no
    result. ['a] must be a plain value that [Marshal] can carry: no functions.
*)

type outcome = {
  output : string;  (** standard output and error of the program *)
  clock : clock;  (** of the whole process, its start and end included *)
}
(** The type for programs that have ended well. *)

val run : ?dir:string -> string -> string list -> (outcome, string) result
(** [run program arguments] runs [program], found as a shell finds it, in the
    directory [dir], by default the current one, without standard input. An
    exit code other than 0 is an error. *)
