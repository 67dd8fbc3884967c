(** The tracer: a function from a scene and a ray to a colour.

    The colour of a ray with [n] rays left in its chain is the background if
    [n] is 0 or the ray hits nothing, and otherwise, at the nearest hit on a
    surface that denotes (emission, albedo, mirror),

    {v
    emission + albedo * light + mirror * colour of the mirrored ray (n - 1 left)
    v}

    where [light] is the sum, in the order of the scene, of what each light
    gives that the surface faces and nothing blocks.

    These functions make an {!Evaluator} for each question; who asks many times
    keeps one. Where a chain of mirrored rays does not fit on the stack, those
    that follow it raise {!Chain.Too_long}. *)

open Raylab_geometry
open Raylab_scene

val color : Prepared.t -> Ray.t -> Color.t
(** [color prepared ray] is the colour that [ray] brings, with the scene's ray
    depth. Each channel is finite and not negative. *)

val pixel : Prepared.t -> x:int -> y:int -> Color.t
(** [pixel prepared ~x ~y] is the colour of pixel [(x, y)], y from the top: the
    mean of its samples, each times the exposure and brought into \[0, 1\].
    What the picture shows is {!Raylab_scene.Film.encode} of it. *)

val nearest_hit : Prepared.t -> Ray.t -> Hit.t option
(** [nearest_hit prepared ray] is the first hit of [ray], or [None] if it hits
    nothing. Of objects hit at the same distance the first of the scene counts.
*)

val light : Prepared.t -> Hit.t -> Color.t
(** [light prepared hit] is the light that reaches [hit]: the ambient light and
    that of all lights of the scene, as a ray with the seed 0 sees it. *)
