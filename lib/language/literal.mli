(** Things that are written in numbers alone, built as soon as they are read.
*)

val object_ : Syntax.placed -> Syntax.item
(** [object_ placed] is the object that [placed], a shape, writes, if all of it
    is numbers and as it should be; else [placed], to be evaluated. *)

val light : Syntax.placed -> Syntax.item
(** [light placed] is the same of a light. *)
