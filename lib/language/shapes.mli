(** The words for shapes. *)

open Raylab_geometry
open Raylab_expression

val sphere : Expression.t -> Expression.t -> Shape.t Written.t
(** [sphere centre radius] is a ball. *)

val plane : Expression.t -> Expression.t -> Shape.t Written.t
(** [plane point normal] is a plane without end. *)
