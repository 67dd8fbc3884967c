(** Surfaces as expressions, for what is evaluated at each point. *)

open Raylab_expression

val make : Syntax.surface -> Expression.t option
(** [make surface] is [surface], its words as
    {!Raylab_expression.Expression.Word}; [None] if it is nested deeper than
    {!Raylab_scene.Surface.max_nesting}. *)
