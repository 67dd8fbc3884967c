(** The inner loop: from a ray in a register to its colour.

    This, with its part {!Lighting}, is the one place where the meaning of a
    scene is computed; {!Tracer} gives it a pure face. It keeps what it is at
    in {!Registers}, which nobody else sees. *)

open Raylab_geometry
open Raylab_scene

type t
(** The type for evaluators: the registers that one domain works with. *)

val create : ?observe:(Event.t -> unit) -> Prepared.t -> t
(** [create prepared] is a new evaluator for the scene [prepared]. It tells
    [observe] each event of what it evaluates; without it no event is made. *)

val tally : t -> Tally.t
(** [tally t] is what [t] has done so far. *)

val color : t -> Ray.t -> Color.t
(** [color t r] is the colour of [r], with the scene's ray depth. It is not
    counted as a primary ray.

    Raises {!Chain.Too_long} if the chain of mirrored rays does not fit on the
    stack. [t] can then be asked for other rays. *)

val sample : t -> x:int -> y:int -> int -> Color.t
(** [sample t ~x ~y k] is the colour of the ray of sample [k] of pixel
    [(x, y)]; see {!Raylab_scene.Sample_ray}.

    Raises {!Chain.Too_long} like {!color}. *)

val nearest_hit : t -> Ray.t -> Hit.t option
(** [nearest_hit t r] is the first hit of [r], if there is one. *)

val light : t -> Hit.t -> Color.t
(** [light t hit] is the light that reaches [hit], as a ray with the seed 0
    sees it. *)
