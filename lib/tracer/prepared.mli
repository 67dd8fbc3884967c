(** Scenes made ready for the inner loop: whatever does not depend on the ray,
    worked out. *)

open Raylab_geometry
open Raylab_scene

type t = private {
  scene : Scene.t;
  lights : Light.t array;
  objects : Object.t array;
  shapes : Shape.t array;  (** of the objects *)
  lobes : float array;
      (** what surfaces denote, row by row; see {!Raylab_scene.Raw_lobes} *)
  rows : int array;
      (** where the row of each object's surface starts; {!varies} if that is
          to be asked at each point *)
  levels : int;  (** how deep surfaces nest, {!Raylab_scene.Surface.levels} *)
  index : Finder.index;
  offset : float;  (** the usual one; see {!Raylab_geometry.Offset} *)
}
(** The type for prepared scenes. *)

val make :
  ?domains:int -> ?index:(Shape.t array -> Finder.index) -> Scene.t -> t
(** [make scene] is [scene] made ready. [index] is the way of finding hits, by
    default {!Raylab_geometry.Bvh.index} on at most [domains] domains, by
    default 1; it makes no difference to any colour. *)

val with_camera : Camera.t -> t -> t
(** [with_camera camera t] is [t] seen by [camera], at once: it is what {!make}
    makes of {!Raylab_scene.Scene.with_camera}. *)

val numbered_object : t -> int -> Object.t
(** [numbered_object t k] is the object of number [k], counted from 1, at once
    also in a scene of millions.

    Raises [Invalid_argument] if there is none. *)

val numbered_light : t -> int -> Light.t
(** [numbered_light t k] is {!numbered_object} for lights. *)

val varies : int
(** [varies] is -1. *)
