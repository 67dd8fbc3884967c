(** Meshes for tests. *)

open Raylab_geometry
open Raylab_source

val all : Mesh.t list
(** [all] is a cube and a tetrahedron, which are closed, and a roof, which is
    open and has normals of its own; each as it is and smooth. *)

val solid : Mesh.t list
(** [solid] is those that are closed. *)

val access : Access.t
(** [access] reaches the files of {!all} by their names, and no others. *)
