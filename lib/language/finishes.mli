(** The words for surfaces that have no others in them. *)

open Raylab_scene
open Raylab_expression

val diffusive : Expression.t -> Surface.t Written.t
(** [diffusive color] returns light to all sides. *)

val reflective : Surface.t Written.t
(** [reflective] is a perfect mirror. *)

val luminous : Expression.t -> Surface.t Written.t
(** [luminous color] glows. *)

val glossy : Expression.t -> Expression.t -> Surface.t Written.t
(** [glossy sharpness color] shows the highlights of the lights. *)

val refractive : Expression.t -> Expression.t -> Surface.t Written.t
(** [refractive index color] lets what is behind it through. *)

val glass : Expression.t -> Expression.t -> Surface.t Written.t
(** [glass index color] mirrors and lets through. *)
