(** Stanford's PLY: elements of properties, as text or in binary.

    Read are the [x], [y], [z] of an element [vertex], in any order, its
    normals [nx], [ny], [nz], if it has all three, and the list
    [vertex_indices] or [vertex_index] of an element [face]. All else is
    skipped; colours and other elements are told in a warning. In a text each
    row has a line of its own. *)

val read : most:int -> string -> Builder.t
(** [read ~most bytes] is the mesh in [bytes], of at most so many triangles.
    Raises {!Fault.Found}. *)
