(** Passes: the order in which a picture that is watched becomes finer.

    The first pass computes every 8th pixel of every 8th row, the second every
    4th, but for those that are there already, and so on: every pixel is
    computed once. *)

type t
(** The type for passes. *)

val whole : t
(** [whole] is all pixels in one pass. *)

val coarse_to_fine : t array
(** [coarse_to_fine] is passes that together compute each pixel once. *)

val step : t -> int
(** [step pass] is how far apart the known pixels are after [pass], in a row
    and from row to row: a power of two that divides {!Tile.side}. *)

val pixels : t -> Tile.t -> int
(** [pixels pass tile] is how many pixels of [tile] [pass] computes. *)

val iter : t -> Tile.t -> (x:int -> y:int -> unit) -> unit
(** [iter pass tile f] is [f ~x ~y] for these pixels. *)
