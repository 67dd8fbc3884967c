(** Scenes made ready for the inner loop: whatever does not depend on the ray,
    worked out. *)

open Raylab_geometry
open Raylab_scene

type clear = {
  numbers : int array;  (** of the objects *)
  index : Index.t;  (** over these; see {!clear_number} *)
}
(** The type for objects that shadow rays may go through. *)

type t = private {
  scene : Scene.t;
  centres : Camera.centres;  (** of its pixels *)
  lights : Light.t array;
  objects : Object.t array;
  shapes : Shape.t array;
      (** of the objects; faces of solids coincide within the usual offset *)
  surfaces : Surfaces.t;
  index : Index.t;
  casters : int array option;
      (** the numbers of the objects that end shadow rays; [None] for all *)
  shadow_index : Index.t;  (** over these; see {!caster} *)
  clear : clear option;  (** what shadow rays may go through, if any *)
  shadowless : int array;  (** the numbers of what no shadow ray meets *)
  offset : float;  (** the usual one; see {!Raylab_geometry.Offset} *)
}
(** The type for prepared scenes. *)

val make : ?domains:int -> ?index:(Shape.t array -> Index.t) -> Scene.t -> t
(** [make scene] is [scene] made ready. [index] is the way of finding hits, by
    default {!Raylab_geometry.Index.hierarchy} on at most [domains] domains, by
    default 1; it makes no difference to any colour. *)

val with_camera : Camera.t -> t -> t
(** [with_camera camera t] is [t] seen by [camera], at once: it is what {!make}
    makes of {!Raylab_scene.Scene.with_camera}. *)

val for_many_rays : ?domains:int -> rays:int -> t -> t
(** [for_many_rays ~rays t] is [t] made ready for so many primary rays, by
    {!Raylab_geometry.Index.for_many_rays} on at most [domains] domains, by
    default 1, if that takes less time than it saves. All colours stay. *)

val numbered_object : t -> int -> Object.t
(** [numbered_object t k] is the object of number [k], counted from 1, at once
    also in a scene of millions.

    Raises [Invalid_argument] if there is none. *)

val numbered_light : t -> int -> Light.t
(** [numbered_light t k] is {!numbered_object} for lights. *)

(** {1 By number}

    Here objects are counted from 0, as they lie in the arrays. *)

val caster : t -> int -> int
(** [caster t k] is the number of what [t.shadow_index] calls [k]. *)

val clear_number : t -> int -> int
(** [clear_number t k] is the number of what [t.clear] calls [k]. *)

val primitive : t -> number:int -> part:int -> int option
(** [primitive t ~number ~part] is which primitive, from 1, [part] of the
    object belongs to; [None] if it is no solid. *)

val own_part : t -> number:int -> part:int -> int
(** [own_part t ~number ~part] is which part of that primitive it is; [part]
    itself if the object is no solid. *)

val surface : t -> number:int -> part:int -> Surface.t
(** [surface t ~number ~part] is the surface of that part. *)

val row : t -> number:int -> part:int -> int
(** [row t ~number ~part] is where its row starts, {!Surfaces.varies}, or that
    of a rich one. *)
