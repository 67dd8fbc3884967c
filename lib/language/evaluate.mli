(** From syntax to a checked scene. *)

open Raylab_source
open Raylab_scene

val scene :
  ?time:float ->
  ?budget:Raylab_expression.Budget.t ->
  Sources.t ->
  Syntax.t ->
  (Scene.t, Scene_error.t list) result
(** [scene ~time ~budget sources syntax] is the scene that [syntax], read from
    [sources], describes at [time], by default 0, or all that is wrong with it.
    It ends, since [budget], by default {!Raylab_expression.Budget.scene}[ ()],
    does. *)
