(** One sentence that says why a ray has its colour.

    Such as
    [a mirror (sphere 4, line 34) that shows the red sphere (object 2, line
     30), lit by light 1, in the shadow of sphere 3 (line 32) from light 2]. It
    names what is hit, the lights that reach it, those that are blocked, and by
    what, and those that it is turned away from; and follows mirrors. Of long
    chains it tells both ends. If a diffusive surface stays black it says why,
    and also if a channel is brighter than a picture can show. *)

open Raylab_scene
open Raylab_tracer

val of_ray : Film.t -> Explain.t -> string
(** [of_ray film e] is the sentence about [e] as [film] shows it, on one line,
    without a full stop. *)

val sees : Film.t -> Explain.t -> string
(** [sees film e] is what [e] sees, with the definite article and nothing of
    brightness: what stands after ["7 of 16 samples see"]. *)
