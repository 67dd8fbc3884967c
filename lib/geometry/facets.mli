(** Facets: triangles with common corners, as a file of a mesh tells of them.

    Plain numbers in flat arrays, of which there may be millions. *)

type t = {
  points : float array;  (** x, y and z of each point; all are finite *)
  normals : float array;
      (** likewise of each normal, of any length but 0; there may be none *)
  corners : int array;
      (** three for each triangle, in the order in which it is wound: the
          places of its corners among the points, from 0 *)
  corner_normals : int array;
      (** the normals at the corners, likewise, -1 for none; empty if no
          triangle has any *)
  faces : int array;
      (** which face of the file each triangle is of, counted from 1: a face
          with more than three corners is several triangles *)
  places : int array;  (** where that face is in the file *)
  in_bytes : bool;
      (** whether {!places} are bytes, from 0, and not lines, from 1 *)
}
(** The type for facets. *)

val none : t
(** [none] is no triangles. *)

val count : t -> int
(** [count facets] is how many triangles there are. *)

val place : t -> int -> string
(** [place facets k] is where the face of triangle [k] is in the file:
    ["line 40"], ["byte 84"]. *)
