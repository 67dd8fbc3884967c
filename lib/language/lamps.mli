(** The words for lights. *)

open Raylab_scene
open Raylab_expression

val directional :
  Expression.t -> Expression.t -> Expression.t -> Light.t Written.t
(** [directional intensity color direction] is light from far away. *)

val spot :
  Expression.t ->
  Expression.t ->
  Expression.t ->
  Expression.t ->
  Expression.t ->
  Expression.t ->
  Light.t Written.t
(** [spot intensity color position target inner outer] is light into a cone. *)

val area :
  Expression.t ->
  Expression.t ->
  Expression.t ->
  Expression.t ->
  Expression.t ->
  Expression.t ->
  Light.t Written.t
(** [area intensity color corner edge other count] is light from a
    parallelogram. *)

val spherical :
  Expression.t -> Expression.t -> Expression.t -> Light.t Written.t
(** [spherical intensity color position] is light from a point. *)
