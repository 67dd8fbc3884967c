(** What becomes of a ray at a surface that lets something through, in words.

    Angles are to the normal, in degrees, with one decimal. *)

open Raylab_tracer

val of_hit : Explain.t -> Explain.surface_hit -> string list
(** [of_hit e h] is a sentence about each refraction of [h], where [e] hits:
    [refracted into the glass (33.7 degrees to the normal become 21.7): 96 %
     goes through, 4.3 % is mirrored], or
    [totally reflected (50 degrees to the normal, and from 41.8 on all is)]. *)

val whence : Explain.t -> Explain.t -> string
(** [whence e next] is how [next], which [e] sends on, came about:
    [, mirrored], [, totally reflected] or [, refracted]. *)
