(** Models: a file's mesh as it is, and smooth. *)

open Raylab_geometry

type t
(** The type for models. *)

val make : name:string -> Facets.t -> t
(** [make ~name facets] is the model of [facets], of which there is at least
    one, called [name]. *)

val nothing : t
(** [nothing] is in the place of a file that cannot be read: a triangle. *)

val mesh : t -> is_smooth:bool -> Mesh.t
(** [mesh model ~is_smooth] is its mesh, each time the same: both kinds share
    what they have in common, and what a smooth one has besides is worked out
    when it is asked for first; see {!Smooth}. *)
