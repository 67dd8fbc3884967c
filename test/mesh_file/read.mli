(** Reads meshes for the tests. *)

open Raylab_geometry
open Raylab_mesh_file

val mesh : Mesh_file.format -> string -> Facets.t
(** [mesh format bytes] is the mesh in [bytes], which is in order. *)

val warnings : Mesh_file.format -> string -> string list
(** [warnings format bytes] is what reading it warns of. *)

val fault : Mesh_file.format -> string -> string
(** [fault format bytes] is what is wrong with [bytes]. *)

val triangles : Facets.t -> (float * float * float) list list
(** [triangles facets] is the points of the corners of each triangle. *)

val check_triangles :
  string -> (float * float * float) list list -> Facets.t -> unit
(** [check_triangles what expected facets] asserts {!triangles}. *)

val check_fault : Mesh_file.format -> string -> string -> unit
(** [check_fault format expected bytes] asserts {!fault}. *)
