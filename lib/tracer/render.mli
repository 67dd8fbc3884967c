(** From a scene to a picture, over domains.

    The picture is the same, byte for byte, whatever the number of domains: each
    pixel is computed by one of them, from nothing but the scene. *)

type rows = { first : int; last : int }
(** A band of rows, both ends included, counted from 0 at the top. *)

val all_rows : Trace.t -> rows
(** [all_rows scene] is all rows of the picture of [scene]. *)

val picture :
  ?domains:int ->
  ?rows:rows ->
  ?on_progress:(float -> unit) ->
  Trace.t ->
  Picture.t * Tally.t
(** [picture scene] is the picture of [scene], or of only those [rows] of it,
    and what was done for it. [domains] defaults to
    {!Raylab_parallel.Parallel.default_domains}. [on_progress] is told now and
    then, on the calling domain, the part that is done, and 1 at the end.

    @raise Invalid_argument
      if [rows] are not rows of the picture, or [domains] is not between 1 and
      {!Raylab_parallel.Parallel.max_domains}. *)
