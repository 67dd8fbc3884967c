(** Objects: a shape with a surface, or a solid of such. *)

open Raylab_geometry

type t = private {
  shape : Shape.t;
  surface : Surface.t;  (** of a solid that of its first primitive *)
  primitives : t array;
      (** of a solid, whose shape is {!Raylab_geometry.Shape.Solid}, its
          members, each with its surface and origin; none of any other object
      *)
  is_shadowless : bool;  (** whether no shadow ray meets it *)
  origin : Origin.t;
}
(** The type for objects. *)

val make : ?origin:Origin.t -> Shape.t -> Surface.t -> t
(** [make ~origin shape surface] is the object of this shape and surface, whose
    origin is by default unknown.

    Raises [Invalid_argument] if [shape] is a {!Raylab_geometry.Shape.Solid}.
*)

val solid : ?origin:Origin.t -> t Solid.tree -> t
(** [solid ~origin tree] is the solid that {!Raylab_geometry.Shape.solid} makes
    of the shapes in [tree]. A solid among them is as if its own tree stood
    there.

    Raises [Invalid_argument] where {!Raylab_geometry.Shape.solid} does, or if
    there is no primitive at all. *)

val primitive : t -> int option -> t
(** [primitive o k] is the [k]th primitive of the solid [o], from 1; [o] itself
    for [None].

    Raises [Invalid_argument] if there is none. *)

val shadowless : t -> t
(** [shadowless o] is [o], which no shadow ray meets. *)

val with_origin : Origin.t -> t -> t
(** [with_origin origin o] is [o], of this origin. *)

val surfaces : t -> Surface.t list
(** [surfaces o] is its surface, or those of its primitives. *)

val map_surfaces : (Surface.t -> Surface.t) -> t -> t
(** [map_surfaces f o] is [o] with [f] of each of its surfaces. *)

val with_surface : Surface.t -> t -> t
(** [with_surface surface o] is [o] with this surface, all over it. *)

val transformed : Change.t -> t -> t
(** [transformed change o] is [o] where {!Raylab_geometry.Shape.transformed}
    puts it. Its shape keeps its own coordinates if its surface varies in them.

    Raises [Invalid_argument] likewise. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] have equal shapes and surfaces. Origins
    do not count. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints shape and surface on one line; the shape of a solid first, then
    the surfaces of its primitives. *)
