(** Passes: the order in which a picture that is watched becomes finer.

    The first pass computes every 8th pixel of every 8th row, or less of a
    large picture; the second every pixel of half that step, but for those that
    are there already; and so on: every pixel is computed once. *)

type t
(** The type for passes. *)

val whole : t
(** [whole] is all pixels in one pass. *)

val smooth : t
(** [smooth] is all pixels with all their samples in one pass. Other passes
    show their centres. *)

val is_smooth : t -> bool
(** [is_smooth pass] is whether [pass] is {!smooth}. *)

val coarse_to_fine : width:int -> height:int -> t array
(** [coarse_to_fine ~width ~height] is passes that together compute each pixel
    of a picture of this size once, of which the first computes at most
    {!most_at_first}. *)

val coarse_to_smooth : width:int -> height:int -> t array
(** [coarse_to_smooth ~width ~height] is likewise what comes before {!smooth}:
    the last of these computes every second pixel of every second row. *)

val most_at_first : int
(** [most_at_first] is 5,000: so few pixels are seen at once. *)

val step : t -> int
(** [step pass] is how far apart the known pixels are after [pass], in a row
    and from row to row: a power of two. *)

(** {1 Tiles} *)

val side : t -> int
(** [side pass] is the side of the tiles in which [pass] is done: a multiple of
    {!Tile.side}, and so large that even of a coarse pass a tile has some
    pixels. *)

val count : t -> width:int -> height:int -> int
(** [count pass ~width ~height] is how many tiles these are in a picture of
    this size. *)

val nth : t -> width:int -> height:int -> int -> Tile.t
(** [nth pass ~width ~height k] is tile [k] of these, from 0. *)

val pixels : t -> Tile.t -> int
(** [pixels pass tile] is how many pixels of [tile], one of these, [pass]
    computes. *)

val iter : t -> Tile.t -> (x:int -> y:int -> unit) -> unit
(** [iter pass tile f] is [f ~x ~y] for these pixels. *)
