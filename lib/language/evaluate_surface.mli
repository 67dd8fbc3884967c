(** Surfaces, made ready to be evaluated. *)

open Raylab_scene
open Raylab_expression

val compile : Check.t -> Scope.t -> Syntax.surface -> Surface.t Check.ready
(** [compile check scope surface] is [surface]; if something is wrong with it,
    that is told. *)
