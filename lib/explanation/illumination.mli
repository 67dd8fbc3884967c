(** Why a surface is lit, or not: what the lights do there, in words. *)

open Raylab_scene
open Raylab_tracer

val clauses :
  exact:bool -> Film.t -> Explain.t -> Explain.surface_hit -> string list
(** [clauses ~exact film e hit] is what the lights do at the hit of [e], as
    [film] shows it, such as [lit by light 1] and
    [in the shadow of sphere 4 (line 34) from light 2]. None if the surface has
    no albedo. If not [exact] it is alike for points that see the same but for
    how much of a light: without angles and without numbers of points. *)
