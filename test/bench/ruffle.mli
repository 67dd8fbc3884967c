(** Meshes to be measured: a ruffled ring, in as many triangles as one likes.
*)

open Raylab_geometry

val mesh : name:string -> triangles:int -> Mesh.t
(** [mesh ~name ~triangles] is one of about so many triangles. *)

val write : out_channel -> Mesh.t -> unit
(** [write channel mesh] writes it as OBJ. *)
