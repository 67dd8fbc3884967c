(** What readers of meshes write what they read into. *)

open Raylab_geometry

type t
(** The type for meshes that are being read. *)

val create : most:int -> counted_from:int -> t
(** [create ~most ~counted_from] is a new one, of nothing. It may have at most
    [most] triangles, and as many points. Faults tell points and normals by
    numbers from [counted_from], as the file does. *)

val point : t -> Fault.place -> float -> float -> float -> unit
(** [point mesh place x y z] adds a point.

    It is a fault if a number is not finite, or there are too many. *)

val points : t -> int
(** [points mesh] is how many points there are so far. *)

val normal : t -> Fault.place -> float -> float -> float -> unit
(** [normal mesh place x y z] adds a normal, likewise. *)

val normals : t -> int
(** [normals mesh] is how many normals there are so far. *)

(** {1 Faces} *)

val corner : t -> point:int -> normal:int -> unit
(** [corner mesh ~point ~normal] adds a corner to the next face. Both are
    places from 0, of what may be added later; [normal] is -1 for none. *)

val end_face : t -> Fault.place -> unit
(** [end_face mesh place] makes a face of the corners since the last one. It is
    at [place] in the file. It is a fault if it has fewer than three corners.
*)

(** {1 The end} *)

val unused : t -> Fault.place -> string -> unit
(** [unused mesh place what] notes that the file has [what], in the plural,
    such as ["materials"], and that it is not used. *)

val finish : t -> Facets.t * Fault.t list
(** [finish mesh] is the mesh, cut into triangles, and warnings: what is not
    used, and faces that are left out since two of their corners are in one
    place. A normal of length 0 counts as none, and so do all if the file has
    none.

    It is a fault if there is no face, if a corner is at a point or has a
    normal that there is not, if there are too many triangles, or if a face
    cannot be cut. *)
