(** Short ways to write the values that tests are about. *)

open Raylab_geometry
open Raylab_source
open Raylab_scene

val v : float -> float -> float -> Vec3.t
(** [v x y z] is {!Vec3.make}[ x y z]. *)

val dir : float -> float -> float -> Direction.t
(** [dir x y z] is the direction of [v x y z], which is not zero. *)

val ray : Vec3.t -> Vec3.t -> Ray.t
(** [ray o d] is the ray without end from [o] along [d], of any length. *)

val rgb : float -> float -> float -> Color.t
(** [rgb r g b] is {!Color.make}[ r g b]. *)

val grey : float -> Color.t
(** [grey g] is [rgb g g g]. *)

val camera :
  ?width:int ->
  ?height:int ->
  ?canvas_width:float ->
  ?canvas_height:float ->
  ?depth:float ->
  unit ->
  Camera.t
(** [camera ()] is the camera of 1 x 1 pixels, canvas 2 x 2, depth 1, unless
    told otherwise: its only pixel looks along the z axis from (0, 0, -1). *)

(** {1 Places} *)

val files : Files.t
(** [files] is a main file and [wood.scene], of 100 empty lines each. *)

val at_line : int -> Origin.t
(** [at_line n] starts in line [n] of the main one of {!files}. *)

val at_line_of_wood : int -> Origin.t
(** [at_line_of_wood n] starts in line [n] of the other. *)

val place : Origin.t -> Provenance.t option
(** [place origin] is its place in {!files}. *)

(** {1 Objects} *)

val sphere : ?line:int -> Vec3.t -> float -> Surface.t -> Object.t
(** [sphere ~line centre radius surface] is that object, {!at_line} if there is
    a line. *)

val plane : ?line:int -> Vec3.t -> Vec3.t -> Surface.t -> Object.t
(** [plane ~line point normal surface] is that object, likewise. *)
