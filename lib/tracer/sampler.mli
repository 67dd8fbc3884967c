(** The samples of pixels: how many one takes, and their mean.

    A pixel takes its centre. If that, as shown, differs by more than
    {!Centres.threshold} in a channel from the centre of one of the eight
    pixels around it in the picture, it takes 4 samples; then, while any two of
    those taken differ so, as many again, up to the film's samples in all. So
    it depends on the scene alone, and not on what else is rendered. *)

open Raylab_scene

type t
(** The type for samplers: what one domain works with. *)

val create : Prepared.t -> t
(** [create prepared] is a new sampler for the scene [prepared]. *)

val tally : t -> Tally.t
(** [tally t] is what [t] has done so far. *)

(** {1 Pixels} *)

val prepare : ?stop:(unit -> bool) -> t -> Tile.t -> unit
(** [prepare t tile] traces the centres of the pixels of [tile], which counts
    from the top of the whole picture, and of those around it, if there are
    several samples. [tile] is at most {!Centres.largest_side} wide and high.
    It ends early, in vain, when [stop ()]. *)

val pixel : t -> x:int -> y:int -> Color.t
(** [pixel t ~x ~y] is the colour of pixel [(x, y)], which is in the tile that
    was {!prepare}d last: the mean of its samples, exposed. *)

val taken : t -> int
(** [taken t] is how many samples the last {!pixel} took. *)

val centre : t -> x:int -> y:int -> Color.t
(** [centre t ~x ~y] is the colour of the centre of pixel [(x, y)], exposed:
    what a coarse picture shows. *)

val lone_pixel : t -> x:int -> y:int -> Color.t
(** [lone_pixel t ~x ~y] is {!pixel} after preparing what it needs. *)

(** {1 Why there were several} *)

val cause : t -> x:int -> y:int -> Centres.neighbour option
(** [cause t ~x ~y] is the pixel beside [(x, y)], which is in the prepared
    tile, whose centre differs most from its centre, as shown; [None] if none
    differs by more than {!Centres.threshold}. *)
