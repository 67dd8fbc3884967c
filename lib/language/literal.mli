(** Things that are written in numbers alone, built as soon as they are read.
*)

val item : Syntax.placed -> Syntax.item
(** [item placed] is the object or light that [placed] writes, if all of it is
    numbers and as it should be; else [placed], to be evaluated. *)
