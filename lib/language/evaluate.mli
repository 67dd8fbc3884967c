(** From syntax to a checked scene. *)

open Raylab_source
open Raylab_scene

val scene :
  ?time:float -> Sources.t -> Syntax.t -> (Scene.t, Scene_error.t list) result
(** [scene ~time sources syntax] is the scene that [syntax], read from
    [sources], describes at [time], by default 0, or all that is wrong with it.
    It ends, after a number of steps that {!Raylab_expression.Budget} bounds.
*)
