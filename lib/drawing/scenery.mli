(** What stands still in a panel: eye, canvas, objects. *)

open Raylab_scene

val draw : Panel.t -> Scene.t -> Path.t -> Sketch.t * Sketch.t
(** [draw panel scene path] is all of them, objects as {!Silhouette.draw} draws
    them, at the level of their first hit, or of the eye; and the numbers of
    objects that [path] does not meet, if there are no more than 30, which are
    the least important labels. What [path] meets is labelled with name and
    number. Of more than 300 objects only the largest are drawn, and those that
    [path] meets. *)
