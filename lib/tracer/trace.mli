(** The tracer: a function from a scene and a ray to a colour.

    The colour of a ray with [n] rays left in its chain is the background if
    [n] is 0 or the ray hits nothing, and otherwise, at the nearest hit on a
    surface that denotes (emission, albedo, mirror),

    {v
    emission + albedo * light + mirror * colour of the mirrored ray (n - 1 left)
    v}

    where [light] is the sum, in the order of the scene, of what each light
    gives that the surface faces and nothing blocks. *)

open Raylab_geometry
open Raylab_scene

type t
(** The type for scenes made ready for tracing. *)

val prepare :
  ?domains:int -> ?index:(Shape.t array -> Finder.index) -> Scene.t -> t
(** [prepare scene] is [scene] made ready. [index] is the way of finding hits,
    by default {!Raylab_geometry.Bvh.index} on at most [domains] domains, by
    default 1; it makes no difference to any colour. *)

val scene : t -> Scene.t
(** [scene t] is the scene from which [t] was prepared. *)

val numbered_object : t -> int -> Object.t
(** [numbered_object t k] is the object of number [k], counted from 1, at once
    also in a scene of millions.

    Raises [Invalid_argument] if there is none. *)

val numbered_light : t -> int -> Light.t
(** [numbered_light t k] is {!numbered_object} for lights. *)

val evaluator : ?observe:(Event.t -> unit) -> t -> Evaluator.t
(** [evaluator t] is a new evaluator of the scene, for the use of one domain;
    see {!Evaluator.create}. *)

val ray : t -> Ray.t -> Color.t
(** [ray t r] is the colour that [r] brings, with the scene's ray depth. Each
    channel is finite and not negative. *)

val pixel : t -> x:int -> y:int -> Color.t
(** [pixel t ~x ~y] is the colour of the primary ray of pixel [(x, y)], y from
    the top. *)

val primary_rays : Scene.t -> Ray.t Seq.t
(** [primary_rays scene] is the ray of each pixel, row by row from the top. *)

(** {1 Steps of the tracer} *)

val nearest_hit : t -> Ray.t -> Hit.t option
(** [nearest_hit t r] is the first hit of [r], or [None] if it hits nothing. Of
    objects hit at the same distance the first of the scene counts. *)

val light : t -> Hit.t -> Color.t
(** [light t hit] is the light that reaches [hit] from all lights of the scene.
*)
