(** Objects: a shape with a surface. *)

open Raylab_geometry

type t = {
  shape : Shape.t;
  surface : Surface.t;
  line : int option;  (** where a scene file has it, lines counted from 1 *)
}
(** The type for objects. *)

val make : ?line:int -> Shape.t -> Surface.t -> t
(** [make shape surface] is the object of this shape and surface. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] have equal shapes and surfaces. Lines do
    not count. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints shape and surface on one line. *)
