(** The rounds of loops, as they are gone through. *)

open Raylab_source

(** The type for what a loop goes through, made ready to be evaluated. *)
type 'thing range =
  | To of {
      first : 'thing Frame.t -> float;
      last : 'thing Frame.t -> float;
      step : 'thing Frame.t -> float;
      step_of : Expression.t;  (** what is wrong if the step is 0 *)
    }
  | In of {
      list : 'thing Frame.t -> 'thing Value.t;
      written : Expression.t;  (** the list *)
    }

val each :
  at:Span.t ->
  'thing range ->
  'thing Frame.t ->
  ('thing Value.t -> unit) ->
  unit
(** [each ~at range frame f] is [f] of the value of each round of [range],
    evaluated in [frame], one after the other. Each round is a step, at [at].
*)
