(** Stanford's PLY: elements of properties, as text or in binary.

    Read are the [x], [y], [z] of an element [vertex], in any order, its
    normals [nx], [ny], [nz], if it has all three, and the list
    [vertex_indices] or [vertex_index] of an element [face]. All else is
    skipped; colours and other elements are told in a warning. In a text each
    row has a line of its own. *)

val read : string -> Builder.t
(** [read bytes] is the mesh in [bytes]. Raises {!Fault.Found}. *)
