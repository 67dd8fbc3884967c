(** Scenes made ready for the inner loop: as arrays of numbers. *)

open Raylab_geometry
open Raylab_scene

type t = private {
  source : Scene.t;
  objects : float array;
      (** {!object_size} numbers for each object: centre and radius of a sphere,
          or the normal of a plane and {!no_radius}; then what the surface
          denotes, emission from {!emission_at} on, albedo from {!albedo_at} on,
          mirror at {!mirror_at}; the rest is unused, so that objects begin on
          even places *)
  lights : float array;
      (** {!light_size} numbers for each light: 1 for a point light and 0 for a
          directional one; the position, or the direction towards the light; the
          power *)
  index : Query.index;
  offset : float;
      (** how far off a surface a ray that leaves it starts, unless the numbers
          there are so large that it would be lost in rounding errors *)
}

val object_size : int
val emission_at : int
val albedo_at : int
val mirror_at : int

val no_radius : float
(** [no_radius] stands for the radius of what is no sphere. *)

val light_size : int

val prepare : index:(Shape.t array -> Query.index) -> Scene.t -> t
(** [prepare ~index scene] is [scene] made ready, with [index] to find hits. *)
