(** What is wrong with scenes, for other programs, as JSON (RFC 8259). *)

open Raylab_geometry
open Raylab_language

val version : int
(** [version] is the version of the schema. *)

val schema : string
(** [schema] says what the document is, for people. *)

type scene = { path : string; problems : Problem.t list; meshes : Mesh.t list }
(** The type for what was found in the scene at a path. *)

val document : scene list -> Yojson.Safe.t
(** [document scenes] is the document about these. *)
