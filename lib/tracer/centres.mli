(** The centres of the pixels of a tile and of those around it. *)

open Raylab_scene

type t
(** The type for centres: a register, filled for one tile after another. *)

val create : Film.t -> Camera.t -> t
(** [create film camera] is a new register for the picture of [camera] on
    [film]; one that is never filled if that takes one sample a pixel. *)

val largest_side : int
(** [largest_side] is 32, of a tile. *)

val fill :
  stop:(unit -> bool) -> t -> Tile.t -> (x:int -> y:int -> Color.t) -> unit
(** [fill ~stop t tile trace] fills [t] with [trace ~x ~y], not exposed, of
    each pixel of [tile], which counts from the top of the whole picture, and
    of those of the picture around it. It ends early, in vain, when [stop ()].

    What follows is about pixels of that tile. *)

val color : t -> x:int -> y:int -> Color.t
(** [color t ~x ~y] is the centre of pixel [(x, y)], exposed. *)

val is_over_exposed : t -> x:int -> y:int -> bool
(** [is_over_exposed t ~x ~y] is whether it is; see
    {!Raylab_scene.Film.over_exposed}. *)

(** {1 Differences} *)

val threshold : float
(** [threshold] is 1/32. *)

val has_other_neighbour : t -> x:int -> y:int -> bool
(** [has_other_neighbour t ~x ~y] is whether the centre of one of the eight
    pixels around [(x, y)], as far as they are in the picture, differs from its
    own as shown, in a channel, by more than {!threshold}. *)

type neighbour = { x : int; y : int; color : Color.t  (** exposed *) }
(** The type for pixels beside a pixel, with their centre. *)

val most_different : t -> x:int -> y:int -> neighbour option
(** [most_different t ~x ~y] is the one of these that differs most, if it does
    by more than {!threshold}. *)
