(** From a scene to a picture, over domains.

    The picture is the same, byte for byte, whatever the number of domains:
    each pixel is computed by one of them, from nothing but the scene. An
    exception on any of them, such as {!Chain.Too_long}, ends the work on all,
    and is raised in place of a picture. *)

type rows = { first : int; last : int }
(** A band of rows, both ends included, counted from 0 at the top. *)

val all_rows : Prepared.t -> rows
(** [all_rows scene] is all rows of the picture of [scene]. *)

val picture :
  ?domains:int ->
  ?rows:rows ->
  ?on_progress:(float -> unit) ->
  Prepared.t ->
  Picture.t * Tally.t
(** [picture scene] is the picture of [scene], or of only those [rows] of it,
    and what was done for it. [domains] defaults to
    {!Raylab_parallel.Parallel.default_domains}. [on_progress] is told now and
    then, on the calling domain, the part that is done, and 1 at the end.

    Raises [Invalid_argument] if [rows] are not rows of the picture, or
    [domains] is not between 1 and {!Raylab_parallel.Parallel.max_domains}. *)

(** {1 Pictures that are watched} *)

val blank : ?rows:rows -> Prepared.t -> Picture.t
(** [blank scene] is an {!Picture.unset} picture of the size that {!picture}
    would have.

    Raises [Invalid_argument] if [rows] are not rows of the picture. *)

val passes : Picture.t -> Prepared.t -> Pass.t array
(** [passes picture scene] is the passes in which {!refine} fills [picture]. If
    there are several samples, all pixels are computed once more in the last.
*)

val refine :
  ?domains:int ->
  ?rows:rows ->
  ?stop:(unit -> bool) ->
  on_tile:(Pass.t -> Tile.t -> unit) ->
  Picture.t ->
  Prepared.t ->
  Tally.t
(** [refine ~on_tile picture scene] fills [picture], a {!blank} one, with the
    pixels of {!val-picture}, coarse first; see {!Pass}. When the pixels of a
    tile in a pass are there, [on_tile] is told so by the domain that computed
    them. Passes of a tile may be done in another order than they were begun.

    Soon after [stop ()], which every domain asks for every pixel, is true,
    [refine] ends, with part of the picture.

    Raises [Invalid_argument] if [picture] has another size, and where
    {!val-picture} does. *)
