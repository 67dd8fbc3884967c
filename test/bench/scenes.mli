(** The scenes of the benchmark, made by rules and a fixed seed: the same on
    every machine. *)

open Raylab_scene

type t = {
  name : string;  (** what the command line calls it *)
  title : string;  (** what the tables call it *)
  spheres : int;  (** or triangles *)
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
(** [all] is 10, 100, ... 1,000,000 random spheres, the sphereflake, the mirror
    room, and meshes of 1,000, 100,000 and 1,000,000 triangles. *)

val mesh_name : string -> string
(** [mesh_name name] is the file of the mesh of the scene called [name], if it
    has one. *)

val meshes : Scene.t -> Raylab_geometry.Mesh.t list
(** [meshes scene] is those whose files must lie beside that of [scene]. *)

val find : string -> t option
(** [find name] is the scene of that name. *)
