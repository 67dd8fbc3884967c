(** What stands still in a picture of a path: eye, canvas, objects. *)

open Raylab_scene
open Raylab_tracer

val draw : View.t -> Scene.t -> Explain.t -> Drawn.t * Drawn.t
(** [draw view scene e] is all of them, objects as {!Silhouette.draw} draws
    them, at the level of their first hit, or of the eye; and the numbers of
    objects that the path does not meet, if there are no more than 30, which
    are the least important labels. What the path meets is labelled with name
    and number. Of more than 300 objects only the largest are drawn, and those
    that the path meets. *)
