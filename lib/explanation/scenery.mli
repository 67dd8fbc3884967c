(** What stands still in a picture of a path: eye, canvas, objects. *)

open Raylab_scene
open Raylab_tracer

type t = { shapes : Svg.t list; labels : Svg.t list }
(** The type for what is drawn: [shapes], farthest first, and [labels], which
    nothing should cover. *)

val draw : View.t -> Scene.t -> Explain.t -> t
(** [draw view scene e] is all of them, objects as {!Silhouette.draw} draws
    them, at the level of their first hit, or of the eye. What the path meets
    is labelled with name and number; other objects, if there are no more than
    30, with their number. Of more than 300 objects only the largest are drawn,
    and those that the path meets. *)
