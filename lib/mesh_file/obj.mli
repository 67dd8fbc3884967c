(** Wavefront OBJ: texts of points, normals and faces.

    Read are [v], [vn] and [f], whose corners are [point], [point/texture],
    [point//normal] or [point/texture/normal], counted from 1, or from -1
    backwards from what stands before. All else is not used: what a reader
    would miss, such as materials, colours, curves, lines and points, is told
    in a warning; names and smoothing groups are not. *)

val read : most:int -> string -> Builder.t
(** [read ~most text] is the mesh in [text], of at most so many triangles.
    Raises {!Fault.Found}. *)
