(** The words for surfaces that have no others in them. *)

open Raylab_scene
open Raylab_expression

val diffusive : Expression.t -> Surface.t Written.t
(** [diffusive color] returns light to all sides. *)

val reflective : Surface.t Written.t
(** [reflective] is a perfect mirror. *)

val luminous : Expression.t -> Surface.t Written.t
(** [luminous color] glows. *)
