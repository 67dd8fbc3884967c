(** The words for shapes. *)

open Raylab_geometry
open Raylab_expression

val sphere : Expression.t -> Expression.t -> Shape.t Written.t
(** [sphere centre radius] is a ball. *)

val plane : Expression.t -> Expression.t -> Shape.t Written.t
(** [plane point normal] is a plane without end. *)

val box : Expression.t -> Expression.t -> Shape.t Written.t
(** [box corner opposite] is a box with sides along the axes. *)

val cylinder :
  Expression.t -> Expression.t -> Expression.t -> Shape.t Written.t
(** [cylinder a b radius] is a cylinder, closed at both ends. *)

val cone :
  Expression.t ->
  Expression.t ->
  Expression.t ->
  Expression.t ->
  Shape.t Written.t
(** [cone a radius_a b radius_b] is a cone, closed at both ends. *)

val torus :
  Expression.t ->
  Expression.t ->
  Expression.t ->
  Expression.t ->
  Shape.t Written.t
(** [torus centre axis ring tube] is a ring. *)

val disc : Expression.t -> Expression.t -> Expression.t -> Shape.t Written.t
(** [disc centre normal radius] is flat and round. *)

val triangle :
  Expression.t -> Expression.t -> Expression.t -> Shape.t Written.t
(** [triangle a b c] is a triangle. *)

val quad : Expression.t -> Expression.t -> Expression.t -> Shape.t Written.t
(** [quad corner edge other] is a parallelogram. *)

val mesh : Raylab_mesh_file.Model.t -> is_smooth:bool -> Shape.t Written.t
(** [mesh model ~is_smooth] is the mesh of a file. *)
