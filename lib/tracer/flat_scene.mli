(** Scenes made ready for the inner loop: as arrays of numbers. *)

open Raylab_geometry
open Raylab_scene

type t = private {
  source : Scene.t;
  objects : Object.t array;
  numbers : float array;
      (** {!object_size} numbers for each object: centre and radius of a
          sphere, or {!no_radius} for another shape; then what the surface
          denotes, emission from {!emission_at} on, albedo from {!albedo_at}
          on, mirror at {!mirror_at}; at {!varies_at} 1 if that is to be asked
          anew at each point, and 0 otherwise *)
  lights : float array;
      (** {!light_size} numbers for each light: 1 for a spherical light and 0
          for a directional one; the position, or the direction towards the
          light; the power *)
  index : Query.index;
  offset : float;
      (** how far off a surface a ray that leaves it starts, unless the numbers
          there are so large that it would be lost in rounding errors *)
}

val object_size : int
val emission_at : int
val albedo_at : int
val mirror_at : int
val varies_at : int

val no_radius : float
(** [no_radius] stands for the radius of what is no sphere. *)

val light_size : int

val write_meaning : float array -> Surface.meaning -> unit
(** [write_meaning row meaning] puts [meaning] into its places in [row], which
    is as long as {!object_size}. *)

val prepare :
  quick:bool -> index:(Shape.t array -> Query.index) -> Scene.t -> t
(** [prepare ~quick ~index scene] is [scene] made ready, with [index] to find
    hits. If [quick] is false every surface is asked anew at each point. *)
