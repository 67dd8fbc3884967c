(** The normals at the corners of a smooth mesh. *)

open Raylab_geometry

val facets : Facets.t -> Facets.t
(** [facets f] is [f] with a normal of length 1 at each corner of a triangle:
    that of the file, or where it has none the mean of the normals of the
    triangles around the point, weighted by their angles there (G. Thürmer and
    C. Wüthrich, {e Computing vertex normals from polygonal facets}, 1998).
    Points in the same place are one. Where the mean has no direction it is the
    triangle's own normal. *)
