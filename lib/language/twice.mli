(** Names that are defined twice in a block. *)

open Raylab_source

type t
(** The type for the names of a block that have been defined. *)

val start : Check.t -> t
(** [start check] is none. *)

val included : t -> Span.t -> File_code.t -> unit
(** [included names span file] notes what [file] defines, which is included at
    [span]. A definition that comes from two files that include a third is one.
*)

val item : t -> Syntax.item -> unit
(** [item names item] notes what [item] defines, and tells if that is defined a
    second time. *)
