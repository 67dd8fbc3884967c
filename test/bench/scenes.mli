(** The scenes of the benchmark, made by rules and a fixed seed: the same on
    every machine. *)

open Raylab_scene

type t = {
  name : string;  (** what the command line calls it *)
  title : string;  (** what the tables call it *)
  spheres : int;
  random : bool;  (** whether it is one of the scenes that the goals name *)
  scene : unit -> Scene.t;
}
(** The type for scenes of the benchmark. *)

val width : int
(** [width] is the width of every picture, 640 pixels. *)

val height : int
(** [height] is the height of every picture, 480 pixels. *)

val million : string
(** [million] is the name of the scene of a million spheres. *)

val all : t list
(** [all] is 10, 100, ... 1,000,000 random spheres, the sphereflake and the
    mirror room. *)

val find : string -> t option
(** [find name] is the scene of that name. *)
