(** STL: triangles one by one, as text or in binary.

    A file is binary if its length is that which its count of triangles asks
    for, whatever it begins with; otherwise it is a text, which begins with
    [solid]. Points in the same place are one. The normals in the file are not
    read: a triangle is wound so that it has its own. *)

val read : most:int -> string -> Builder.t
(** [read ~most bytes] is the mesh in [bytes], of at most so many triangles.
    Raises {!Fault.Found}. *)
