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

val point : Facets.t -> int -> Vec3.t
(** [point facets k] is the point [k], from 0. *)

val volume : Facets.t -> apex:Vec3.t -> float
(** [volume facets ~apex] is the volume of what a closed mesh encloses,
    whatever [apex] is; negative if the normals of its triangles, as they are
    wound, point inward. The nearer [apex] is, the less is lost by rounding. Of
    a mesh that is open it is that of the cones from [apex] to the triangles.
*)

val area : Facets.t -> Vec3.t * float
(** [area facets] is the sum of the normals of all triangles, each as long as
    its area, and the whole area. *)
