(** Calls and rounds in words, for errors. *)

open Raylab_source
open Raylab_expression

val tell : Files.t -> Trail.t -> string list
(** [tell files trail] is a line for each call and round of [trail], the
    innermost first, such as [in ring(n: 2), called in line 9]. Of a deep
    recursion there are the first and the last ones. *)
