(** Rows of a picture, piece by piece. Rows are counted from 0 at the top of
    the whole picture. *)

type t = first:int -> count:int -> bytes
(** The type for ways to get rows, [count] of them from [first] on: their red,
    green and blue bytes, row by row. *)

val of_bytes : width:int -> top:int -> bytes -> t
(** [of_bytes ~width ~top rgb] is the rows in [rgb], of which the first is row
    [top]. *)

val pieces : width:int -> first:int -> last:int -> (int * int) Seq.t
(** [pieces ~width ~first ~last] is rows [first] to [last] as pieces
    [(first, count)], from the topmost on, each of at most a megabyte or of one
    row. *)

val iter :
  lowest_first:bool ->
  width:int ->
  first:int ->
  last:int ->
  (bytes -> unit) ->
  t ->
  unit
(** [iter ~lowest_first ~width ~first ~last f rows] is [f] of each of the
    {!pieces}, from the topmost or from the lowest on. *)
