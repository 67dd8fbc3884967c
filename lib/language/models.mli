(** The meshes of a scene, each of which is read once. *)

open Raylab_source
open Raylab_scene
open Raylab_mesh_file

type t
(** The type for meshes that have been read. *)

val start : unit -> t
(** [start ()] is none. *)

val find :
  t ->
  at:int ->
  name:string ->
  (unit -> (string, Access.refusal) result) ->
  Access.found ->
  (Model.t * string, Access.refusal) result
(** [find models ~at ~name bytes found] is the mesh in the file [found], and
    the path by which that was read. It is called [name] where it is used, at
    the offset [at]. If it has not been read yet, [bytes ()] is what it holds.
    All together have at most {!Raylab_mesh_file.Mesh_file.most_triangles}. *)

val meshes : t -> Raylab_geometry.Mesh.t list
(** [meshes models] is all of them, none smooth, in the order in which they
    were read. *)

val warnings : t -> Warning.t list
(** [warnings models] is what their files have and raylab does not use, in the
    order in which they were read. *)
