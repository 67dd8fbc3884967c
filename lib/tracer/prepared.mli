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

val make : index:(Shape.t array -> Finder.index) -> Scene.t -> t
(** [make ~index scene] is [scene] made ready, with [index] to find hits. *)

val varies : int
(** [varies] is -1. *)
