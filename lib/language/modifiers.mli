(** The words that change what stands before them. *)

open Raylab_geometry
open Raylab_expression

val scaled : Expression.t -> Similarity.t Written.t
(** [scaled factor] makes it larger or smaller, seen from the origin. *)

val stretched : Expression.t -> Similarity.t Written.t
(** [stretched factors] is refused: shapes cannot be stretched yet. *)

val rotated : Expression.t -> Expression.t -> Similarity.t Written.t
(** [rotated axis angle] turns it around an axis through the origin. *)

val translated : Expression.t -> Similarity.t Written.t
(** [translated way] moves it. *)
