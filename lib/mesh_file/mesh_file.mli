(** Files of meshes: from bytes to a mesh, or what is wrong with them. *)

open Raylab_geometry

(** The type for formats. *)
type format =
  | Obj  (** Wavefront: {!module-Obj} *)
  | Ply  (** Stanford: {!module-Ply} *)
  | Stl  (** stereolithography: {!module-Stl} *)

val formats : (string * format) list
(** [formats] is the extensions of names of files: [obj], [ply], [stl]. *)

val format_of_name : string -> format option
(** [format_of_name name] is the format that the extension of [name] tells, in
    whatever case it is. *)

val most_triangles : int
(** [most_triangles] is 20 million: how many triangles all meshes of a scene
    may have together. *)

val read :
  ?most:int -> format -> string -> (Facets.t * Fault.t list, Fault.t) result
(** [read ~most format bytes] is the mesh in [bytes], of at most [most]
    triangles and points, by default {!most_triangles}, and warnings: what the
    file has and raylab cannot use. *)
