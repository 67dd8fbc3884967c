(** From syntax to a checked scene. *)

open Raylab_scene

val scene :
  ?time:float -> Source.t -> Syntax.t -> (Scene.t, Scene_error.t list) result
(** [scene ~time source syntax] is the scene that [syntax], read from [source],
    describes at [time], by default 0, or all that is wrong with it. It ends,
    after a number of steps that {!Raylab_expression.Budget} bounds. *)
