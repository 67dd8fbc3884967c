(** How the triangles of a mesh hang together, by where their corners are:
    points in one place are one. *)

val places : Facets.t -> int array
(** [places facets] is for each point the first point that is in the same
    place. *)

type edge = {
  triangle : int;
  side : int;
      (** of the triangle: from its corner of this number to the next *)
  faces : int;  (** how many triangles have it *)
}
(** The type for edges of a triangle. *)

val open_edge : Facets.t -> places:int array -> edge option
(** [open_edge facets ~places] is the first edge that is not that of exactly
    two triangles; [None] if there is none: the mesh is closed. *)

val volume : Facets.t -> float
(** [volume facets] is the volume of what a closed mesh encloses; negative if
    the normals of its triangles, as they are wound, point inward. *)
