(** Tiles: the squares of a picture that domains fill one at a time.

    Neighbouring pixels meet the same objects, which a square keeps in the
    cache. *)

type t = { left : int; top : int; width : int; height : int }
(** The type for tiles, in pixels. *)

val side : int
(** [side] is 16, the usual side. *)

val count : side:int -> width:int -> height:int -> int
(** [count ~side ~width ~height] is how many tiles of this side a picture of
    this size has. *)

val nth : side:int -> width:int -> height:int -> int -> t
(** [nth ~side ~width ~height k] is tile [k] of these, from 0, row by row from
    the top. Those at the right and at the bottom may be less wide or high. *)
