(** Tiles: the squares of a picture that domains fill one at a time.

    Neighbouring pixels meet the same objects, which a square keeps in the
    cache. *)

type t = { left : int; top : int; width : int; height : int }
(** The type for tiles, in pixels. Those at the right and at the bottom may be
    less than {!side} wide or high. *)

val side : int
(** [side] is 16. *)

val count : width:int -> height:int -> int
(** [count ~width ~height] is how many tiles a picture of this size has. *)

val nth : width:int -> height:int -> int -> t
(** [nth ~width ~height k] is tile [k], from 0, row by row from the top. *)
