(** The words that change what stands before them. *)

open Raylab_geometry
open Raylab_expression

val scaled : Expression.t -> Change.modifier Written.t
(** [scaled factor] makes it larger or smaller, seen from the origin. *)

val stretched : Expression.t -> Change.modifier Written.t
(** [stretched factors] makes it larger or smaller along each axis; a negative
    factor mirrors it. *)

val rotated : Expression.t -> Expression.t -> Change.modifier Written.t
(** [rotated axis angle] turns it around an axis through the origin. *)

val translated : Expression.t -> Change.modifier Written.t
(** [translated way] moves it. *)
