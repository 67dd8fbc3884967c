(** Writing the values that patterns use. *)

open Raylab_expression

val definitions :
  name_of:(Surface.t -> string option) ->
  Format.formatter ->
  Surface.t Closed.t ->
  unit
(** [definitions ~name_of ppf pattern] writes what defines the names in
    [pattern], each on a line. Surfaces to which [name_of] gives a name are
    written by it. *)

val definition : string * Surface.t Closed.definition -> string
(** [definition (name, d)] is the same in full, as the scene language defines
    it, without [let]. *)

val told : Surface.t Closed.t -> string list
(** [told pattern] is what its names are, for a reader: [k = 2.5],
    [ring(p) = 10 * p.x], of a long list the first elements. *)

val names : Surface.t Closed.t -> string list
(** [names pattern] is all names that are defined or introduced in [pattern],
    in lower case. *)
