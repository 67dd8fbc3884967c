(** What the surfaces of a scene denote, worked out for the inner loop. *)

open Raylab_scene

type t = private {
  lobes : float array;
      (** what plain surfaces denote, row by row; see {!Raylab_scene.Raw_lobes}
      *)
  rows : int array;
      (** where the row of each object's surface starts; or, less than 0,
          {!varies} if that is to be asked at each point, {!of_primitives} if
          each primitive has its own, and otherwise one that {!is_patterned} or
          {!val-rich} *)
  primitive_rows : int array array;
      (** the same for the primitives of each object, if any has some *)
  rich : Raw_lobes.t array;
      (** what surfaces denote that have highlights or refractions *)
  patterned : Surface.ready array;  (** the patterns in others *)
}
(** The type for the surfaces of the objects of a scene, by their place there,
    from 0. *)

val make : Object.t array -> t
(** [make objects] is the surfaces of [objects]. *)

val varies : int
(** [varies] is -1. *)

val of_primitives : int
(** [of_primitives] is -2. *)

val rich : t -> int -> Raw_lobes.t
(** [rich t row] is what the surface with this row denotes, which is less than
    {!of_primitives}. *)

val is_patterned : int -> bool
(** [is_patterned row] is whether there are patterns in the surface with this
    row, which varies. *)

val pattern : int -> int
(** [pattern row] is then where they are in [patterned]. *)
