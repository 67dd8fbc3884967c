(** Objects: a shape with a surface. *)

open Raylab_geometry

type t = { shape : Shape.t; surface : Surface.t; origin : Origin.t }
(** The type for objects. *)

val make : ?origin:Origin.t -> Shape.t -> Surface.t -> t
(** [make ~origin shape surface] is the object of this shape and surface, whose
    origin is by default unknown. *)

val transformed : Change.t -> t -> t
(** [transformed change o] is [o] where {!Raylab_geometry.Shape.transformed}
    puts it. Its shape keeps its own coordinates if its surface varies in them.

    Raises [Invalid_argument] likewise. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] have equal shapes and surfaces. Origins
    do not count. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints shape and surface on one line. *)
