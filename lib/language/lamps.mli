(** The words for lights. *)

open Raylab_scene
open Raylab_expression

val directional :
  Expression.t -> Expression.t -> Expression.t -> Light.t Written.t
(** [directional intensity color direction] is light from far away. *)

val spherical :
  Expression.t -> Expression.t -> Expression.t -> Light.t Written.t
(** [spherical intensity color position] is light from a point. *)
