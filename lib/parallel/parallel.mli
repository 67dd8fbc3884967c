(** Work handed out to domains. *)

val default_domains : unit -> int
(** [default_domains ()] is the number of domains that this machine runs at
    full speed. More are slower than one, since collections wait for all of
    them. *)

val max_domains : int
(** [max_domains] is the most domains that the runtime has, 128. *)

val iter :
  domains:int ->
  ?stop:(unit -> bool) ->
  ?on_progress:(int -> unit) ->
  worker:(unit -> 'w) ->
  count:int ->
  ('w -> int -> unit) ->
  'w list
(** [iter ~domains ~worker ~count work] does [work w k] for each [k] from 0 to
    [count - 1], on at most [domains] domains, the calling one included. Each
    domain makes a [w] of its own by [worker ()] and takes the next [k] that
    nobody has taken, until none is left. The result is the [w]s of all
    domains. Fewer domains than that work where the system grants no more.

    After each piece of work of the calling domain, [on_progress n] is told how
    many pieces are done.

    Once [stop ()], which every domain asks, is true, no further piece is
    taken.

    If [work], [worker] or [on_progress] raises, the other domains stop after
    the piece that they are at, and the exception is raised again.

    Raises [Invalid_argument] if [domains] is not between 1 and {!max_domains}.
*)
