(** Random programs of the scene language, well-formed: every name is known
    where it stands and of the right kind, and loops and calls are few. *)

val number : Random.State.t -> string
(** [number random] is an expression that has a number, of names that are built
    in and of its own. *)

val scene : Random.State.t -> string
(** [scene random] is a scene of definitions, functions, loops, conditions,
    groups and modifiers. Its numbers may be out of range. *)
