(** Items, made ready to be evaluated. *)

val compile : Evaluate_include.item
(** [compile check scope ~at item] is the scope after [item], which stands in a
    block at [at], and what puts its lights and objects into a sink. What is
    wrong with them is told. *)

val tell_twice : Check.t -> Twice.t -> Syntax.item -> unit
(** [tell_twice check names item] notes what [item] defines, and tells if that
    is defined a second time. *)

val block : Evaluate_thing.block
(** [block check scope ~at items frame sink] puts those of [items] into [sink],
    one after the other. Each item is a step, at [at]. *)
