(** A picture that becomes finer, and what is known of it.

    Domains fill the picture itself; this is the notes of the one domain that
    shows it. *)

open Raylab_tracer

type t
(** The type for pictures on the way. *)

val start : passes:Pass.t array -> Picture.t -> t
(** [start ~passes picture] is [picture] with nothing known of it, which is
    filled in [passes]. *)

val complete : Picture.t -> t
(** [complete picture] is [picture] with every pixel known. *)

val picture : t -> Picture.t
(** [picture r] is the picture itself. *)

val size : t -> int * int
(** [size r] is its width and height. *)

val note : t -> Pass.t -> Tile.t -> unit
(** [note r pass tile] notes that [pass] of [tile] is done. *)

val part : t -> float
(** [part r] is which part of the pixels of all passes is known, from 0 to 1.
*)

val is_covered : t -> bool
(** [is_covered r] is whether something is known everywhere: no {!step} is 0.
*)

val step : t -> x:int -> y:int -> int
(** [step r ~x ~y] is the side of the block around pixel [(x, y)] of which one
    pixel, the upper left, is known; blocks are as small as the passes done
    allow. 0 if nothing is known there. *)

val color : t -> x:int -> y:int -> int
(** [color r ~x ~y] is the colour of that known pixel, as [0xRRGGBB]; any
    colour if nothing is known. *)
