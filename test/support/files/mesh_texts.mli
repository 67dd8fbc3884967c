(** Files of small meshes, in memory. *)

open Raylab_source

val all : (string * string) list
(** [all] is names and texts: a cube and a tetrahedron, which are closed, and a
    roof, which is open and has normals. *)

val access : Access.t
(** [access] reaches these by their names, and no others. *)
