(** The highlights of a surface, in words. *)

open Raylab_scene
open Raylab_tracer

val is_all : Lobes.t -> bool
(** [is_all lobes] is whether there is nothing but highlights. *)

val clauses : Film.t -> Explain.surface_hit -> string list
(** [clauses film hit] is [in the highlight of light 1], of the lights whose
    highlights [film] shows there: those that change a channel by more than
    1/32, as samples differ. If it is none of those that reach a surface which
    has nothing but highlights, it is [outside of the highlight of light 1]. *)
