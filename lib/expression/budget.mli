(** What an evaluation may use up, so that it always ends.

    All of it is counted, and nothing depends on time or on the stack: what
    ends here ends so on every machine. *)

open Raylab_source

type t = {
  mutable steps : int;  (** taken *)
  mutable made : int;  (** computed objects and elements of lists *)
  mutable depth : int;  (** of the calls that are going on *)
  most_steps : int;
  most_made : int;
}
(** The type for budgets. *)

val scene_steps : int
(** [scene_steps] is 100 million: the steps of the evaluation of a scene. *)

val pattern_steps : int
(** [pattern_steps] is 100,000: those of an evaluation while rendering. *)

val most_made : int
(** [most_made] is 20 million. *)

val most_calls : int
(** [most_calls] is 1,000: how deep calls nest. *)

val limited : steps:int -> made:int -> t
(** [limited ~steps ~made] is a new budget of that many steps, and that many
    objects and elements of lists. *)

val start : steps:int -> t
(** [start ~steps] is {!limited}[ ~steps ~made:most_made]. *)

val scene : unit -> t
(** [scene ()] is {!start}[ ~steps:scene_steps]. *)

(** {1 Using it}

    What is more than the budget raises {!Fault.Found} at the span. *)

val step : t -> Span.t -> unit
(** [step budget span] takes a step. *)

val steps : t -> Span.t -> int -> unit
(** [steps budget span count] takes [count] steps, at least 0. *)

val make : t -> Span.t -> int -> unit
(** [make budget span count] computes [count] objects or elements. *)

val enter : t -> Span.t -> unit
(** [enter budget span] begins a call. *)

val leave : t -> unit
(** [leave budget] ends it. *)

val grouped : int -> string
(** [grouped 20000000] is ["20,000,000"]. *)

val restart : t -> unit
(** [restart budget] is [budget] with nothing used up. *)
