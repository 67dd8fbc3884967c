(** From syntax to a scene: every rule about numbers, and which settings must
    be there. *)

open Raylab_scene

val scene : Source.t -> Syntax.t -> (Scene.t, Scene_error.t list) result
(** [scene source syntax] is the scene that [syntax], which was read from
    [source], describes, or every error in it, in the order of the text. *)
